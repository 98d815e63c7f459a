using System.Collections.Generic;
using System.Linq;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace Nowpose.Editor.Setup
{
    /// <summary>Formats new values in the style of a JSON text: with the same line endings, indents and spaces.</summary>
    sealed class JsonStyle
    {
        readonly string _text, _newLine, _colon;

        public JsonStyle(string text, JsonOutline root)
        {
            _text = text;
            var end = text.IndexOf('\n', root.Start, root.End - root.Start);
            _newLine = end < 0 ? null : end > 0 && text[end - 1] == '\r' ? "\r\n" : "\n";
            var first = root.Items.FirstOrDefault();
            var gap = first == null ? "" : text.Substring(root.Start + 1, first.ItemStart - root.Start - 1);
            Indent = gap.Contains('\n') && !gap.EndsWith('\n') ? gap.Substring(gap.LastIndexOf('\n') + 1) : "  ";
            _colon = first == null || first.Start == 0 || text[first.Start - 1] != ':' ? ": " : ":";
        }

        /// <summary>Indent of one level.</summary>
        public string Indent { get; }

        string Blank => _colon == ":" ? "" : " ";

        /// <summary>Returns the white space at the start of the line that contains the character at an index.</summary>
        public string IndentAt(int index)
        {
            var start = _text.LastIndexOf('\n', index) + 1;
            var end = start;
            while (end < index && (_text[end] == ' ' || _text[end] == '\t')) end++;
            return _text.Substring(start, end - start);
        }

        /// <summary>Returns the white space before the last item of a container, without empty lines.</summary>
        public string GapBefore(JsonOutline container, JsonOutline last)
        {
            var count = container.Items.Count;
            var from = count == 1 ? container.Start + 1 : container.Items[count - 2].End;
            var between = _text.Substring(from, last.ItemStart - from);
            var gap = between.Substring(between.IndexOf(',') + 1);
            if (gap.Contains('\n')) return _newLine + gap.Substring(gap.LastIndexOf('\n') + 1);
            return count == 1 ? Blank : gap;
        }

        public string Item(string name, JToken value, string indent) =>
            (name == null ? "" : JsonConvert.ToString(name) + _colon) + Value(value, indent);

        /// <summary>Returns the content of a pair of brackets, with line endings and indents before and after it.</summary>
        public string Padded(string indent, string inside) =>
            _newLine == null ? Blank + inside + Blank : _newLine + indent + Indent + inside + _newLine + indent;

        string Value(JToken value, string indent)
        {
            var inner = indent + Indent;
            switch (value)
            {
                case JObject all: return "{" + Block(all.Properties().Select(p => Item(p.Name, p.Value, inner)), indent) + "}";
                case JArray all: return "[" + Block(all.Select(item => Value(item, inner)), indent) + "]";
                default: return JsonConvert.ToString((string)value);
            }
        }

        string Block(IEnumerable<string> items, string indent) =>
            Padded(indent, string.Join("," + (_newLine == null ? Blank : _newLine + indent + Indent), items));
    }
}
