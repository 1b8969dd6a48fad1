-- SPDX-License-Identifier: Apache-2.0
-- Links of the theory manual: (FR-9) to the equation, "table FR-1" to the table, [@key] to the
-- reference.  The Markdown stays readable without them.  Headings are left alone.  A citation of
-- a key that is not in the references, or a missing anchor, is an error: a link leads somewhere.
-- Punctuation next to mathematics, and a unit next to its number, stay on their line.
local anchors, wanted = {}, {}

local function note(element)
  if element.identifier and element.identifier ~= "" then anchors["#" .. element.identifier] = true end
end

local function link(text, target)
  wanted[target] = true
  return pandoc.Link(text, target, "", pandoc.Attr("", {"unbroken"}))
end

local function inlines(list)
  local out, before = pandoc.List(), ""
  for _, inline in ipairs(list) do
    if inline.t == "Cite" then
      for i, citation in ipairs(inline.citations) do
        if i > 1 then out:extend{pandoc.Str(","), pandoc.Space()} end
        out:insert(link("[" .. citation.id .. "]", "#ref-" .. citation.id))
      end
    elseif inline.t == "Str" and inline.text:match("%u%u%-%d+") then
      local kind = before:match("^[(]?[Tt]able$") and "table-" or ""
      local rest = inline.text
      while rest ~= "" do
        local head, tag, tail = rest:match("^(.-)(%u%u%-%d+)(.*)$")
        if not tag then out:insert(pandoc.Str(rest)) break end
        if head ~= "" then out:insert(pandoc.Str(head)) end
        out:insert(link(tag, "#" .. kind .. tag))
        rest = tail
      end
    else
      out:insert(inline)
    end
    if inline.t == "Str" then before = inline.text end
  end
  return out
end

local units = {["%"] = true, mm = true, ["µm"] = true, N = true, MPa = true, ["N/mm"] = true, ["N·m"] = true,
               ["N·mm/rad"] = true, ["N·m/rad"] = true, ["rad/(N·mm"] = true}

local function unbroken(list)
  local out = pandoc.List()
  for i, inline in ipairs(list) do
    local last, after = out[#out], list[i + 1]
    if inline.t == "Space" and last and after and after.t == "Str" and units[after.text:match("^[^,;.:)]*")] then
      inline = pandoc.Str("\u{a0}")
    end
    local opens = inline.t == "Math" and last and last.t == "Str" and last.text:match("[(%[]$")
    local closes = inline.t == "Str" and inline.text:match("^[,;.:)%]]") and last and
                   (last.t == "Math" or last.t == "Span" and last.classes:includes("unbroken"))
    if opens or closes then
      local content = last.t == "Span" and last.content or pandoc.List{last}
      content:insert(inline)
      out[#out] = pandoc.Span(content, pandoc.Attr("", {"unbroken"}))
    else
      out:insert(inline)
    end
  end
  return out
end

local letters = {text = "", alpha = "α", beta = "β", gamma = "γ", theta = "θ", lambda = "λ", nu = "ν", sigma = "σ",
                 tau = "τ", phi = "φ", varphi = "φ", pi = "π", circ = "°", cdot = "·", times = "×", le = "≤", ge = "≥"}

-- What a reader who does not see a picture is told: its caption without TeX.
local function spoken(image)
  local text = pandoc.utils.stringify(pandoc.walk_inline(image, {Math = function(math)
    local plain = math.text:gsub("\\(%a+)", function(name) return letters[name] or error("the caption of a picture has \\" .. name .. ", which has no letter here")
    end)
    return pandoc.Str((plain:gsub("[{}\\]", ""):gsub("%^°", "°"):gsub("~", " ")))
  end}).caption)
  image.attributes.alt = text
  return image
end

function Pandoc(doc)
  for i, block in ipairs(doc.blocks) do
    if block.t ~= "Header" then doc.blocks[i] = pandoc.walk_block(pandoc.walk_block(block, {Inlines = inlines}), {Inlines = unbroken}) end
  end
  doc = doc:walk({Image = spoken})
  local collector = {Header = note, Span = note, Div = note, Image = note, Link = function(element)
    if element.target:sub(1, 1) == "#" then wanted[element.target] = true end
  end}
  pandoc.walk_block(pandoc.Div(doc.blocks), collector)
  for target in pairs(wanted) do
    if not anchors[target] then error("the manual has no anchor " .. target) end
  end
  return doc
end
