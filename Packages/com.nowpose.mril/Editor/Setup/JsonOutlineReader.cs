using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    /// <summary>Finds the values in a JSON text and their positions.</summary>
    /// <remarks>
    /// Rejects comments and trailing commas, because Unity's reader does. Newtonsoft.Json is not used, because it accepts both and does not report
    /// positions.
    /// </remarks>
    sealed class JsonOutlineReader
    {
        const int MaxNesting = 64;

        static readonly Regex Scalar = new Regex(@"\G(?:-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?|true|false|null)", RegexOptions.CultureInvariant);
        static readonly Regex Quoted = new Regex(
            "\\G\"(?:[^\"\\\\\\x00-\\x1f]|\\\\(?:[\"\\\\/bfnrt]|u[0-9a-fA-F]{4}))*\"", RegexOptions.CultureInvariant);

        readonly string _text, _file;
        int _at, _depth;

        JsonOutlineReader(string text, string file)
        {
            _text = text;
            _file = file;
        }

        /// <summary>Reads a string that consists of one JSON object.</summary>
        /// <param name="file">Name of the file in messages.</param>
        /// <exception cref="InputException">The text is not a JSON object.</exception>
        public static JsonOutline Read(string text, string file)
        {
            var reader = new JsonOutlineReader(text, file);
            reader.SkipBlanks();
            if (reader.Next != '{') throw reader.Wrong(ManifestMessages.Expected('{'));
            var root = reader.Value();
            reader.SkipBlanks();
            return reader._at == text.Length ? root : throw reader.Wrong(ManifestMessages.AfterObject);
        }

        /// <summary>Returns the line number of the character at an index. The first line has number 1.</summary>
        public static int LineOf(string text, int index) => 1 + text.Take(index).Count(c => c == '\n');

        char Next => _at < _text.Length ? _text[_at] : '\0';

        JsonOutline Value()
        {
            var value = new JsonOutline { ItemStart = _at, Start = _at };
            if (Next == '{' || Next == '[') ReadItems(value);
            else if (Next == '"') value.Text = ReadString();
            else Skip(Scalar, ManifestMessages.NoValue);
            value.End = _at;
            return value;
        }

        void ReadItems(JsonOutline value)
        {
            if (++_depth > MaxNesting) throw Wrong(ManifestMessages.TooDeep(MaxNesting.ToString(CultureInfo.InvariantCulture)));
            value.IsObject = Next == '{';
            value.Items = new List<JsonOutline>();
            var end = value.IsObject ? '}' : ']';
            _at++;
            SkipBlanks();
            while (Next != end)
            {
                if (value.Items.Count > 0) Take(',');
                var item = value.IsObject ? Member() : Value();
                if (item.Name != null && value[item.Name] != null) throw Wrong(ManifestMessages.Twice(item.Name));
                value.Items.Add(item);
                SkipBlanks();
            }
            _at++;
            _depth--;
        }

        JsonOutline Member()
        {
            var start = _at;
            if (Next != '"') throw Wrong(ManifestMessages.NoName);
            var name = ReadString();
            SkipBlanks();
            Take(':');
            var value = Value();
            value.Name = name;
            value.ItemStart = start;
            return value;
        }

        void Take(char expected)
        {
            if (Next != expected) throw Wrong(ManifestMessages.Expected(expected));
            _at++;
            SkipBlanks();
        }

        string ReadString()
        {
            var start = _at;
            Skip(Quoted, ManifestMessages.StringEnd);
            using (var reader = new JsonTextReader(new System.IO.StringReader(_text.Substring(start, _at - start))))
            {
                reader.DateParseHandling = DateParseHandling.None;
                return (string)JToken.ReadFrom(reader);
            }
        }

        void Skip(Regex pattern, string otherwise)
        {
            var match = pattern.Match(_text, _at);
            if (!match.Success) throw Wrong(otherwise);
            _at += match.Length;
        }

        void SkipBlanks()
        {
            while (Next == ' ' || Next == '\t' || Next == '\r' || Next == '\n') _at++;
        }

        InputException Wrong(string what)
        {
            var line = LineOf(_text, _at).ToString(CultureInfo.InvariantCulture);
            return new InputException(ManifestMessages.NotJson(_file, line, what, Next == '/'));
        }
    }
}
