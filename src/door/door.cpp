// SPDX-License-Identifier: Apache-2.0
#include "strainwave/door/door.hpp"

#include <fmt/format.h>

#include <utility>

#include "strainwave/io/gear_reader.hpp"

namespace strainwave {

std::shared_ptr<const Drive> read_drive(std::string text, std::string name,
                                        Attachments attachments) {
  auto drive = std::make_shared<Drive>();
  drive->gear = read_gear_set(text, name, attachments);
  drive->text = std::move(text);
  drive->name = std::move(name);
  return drive;
}

Answer run(const Command& command, std::shared_ptr<const Drive> drive, const OptionValues& options,
           const OptionTexts& texts, const Progress& progress) {
  if (!drive && command.takes == Takes::drive)
    throw OptionError("drive", fmt::format("must be given; {} works on a drive", command.name));
  static const auto no_drive = std::make_shared<const Drive>();
  return {command, drive ? std::move(drive) : no_drive, options, texts, progress};
}

}  // namespace strainwave
