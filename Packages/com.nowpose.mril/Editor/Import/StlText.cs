using System;
using System.Globalization;
using System.IO;
using System.Text;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Import
{
    /// <summary>
    /// Reads ASCII STL: one or more blocks from solid to endsolid that contain facets with their vertices, with one keyword per line.
    /// </summary>
    sealed class StlText
    {
        const int MaxQuoteLength = 40;

        readonly string _sourceName;
        readonly StlTriangles _triangles = new StlTriangles();
        readonly float[] _corners = new float[9];
        int _line;
        int _facets;
        int _read;
        bool _inSolid;
        bool _inFacet;

        StlText(string sourceName) => _sourceName = sourceName;

        /// <summary>Returns whether the first word of a file is "solid". A binary file may also start with this word.</summary>
        public static bool Begins(byte[] content)
        {
            var first = Encoding.ASCII.GetString(content, 0, Math.Min(content.Length, 64)).TrimStart('?', ' ', '\t', '\r', '\n');
            return first.StartsWith("solid", StringComparison.OrdinalIgnoreCase);
        }

        public static StlTriangles Read(byte[] content, string sourceName)
        {
            var text = new StlText(sourceName);
            using (var reader = new StreamReader(new MemoryStream(content), Encoding.UTF8))
                for (var line = reader.ReadLine(); line != null; line = reader.ReadLine()) text.Take(line);
            text.End();
            return text._triangles;
        }

        void Take(string line)
        {
            _line++;
            var words = line.Split((char[])null, StringSplitOptions.RemoveEmptyEntries);
            if (words.Length == 0) return;
            switch (words[0].ToLowerInvariant())
            {
                case "solid": Require(!_inSolid, StlMessages.SolidInSolid); _inSolid = true; break;
                case "endsolid": Require(_inSolid && !_inFacet, StlMessages.EndSolid); _inSolid = false; break;
                case "facet": BeginFacet(); break;
                case "endfacet": EndFacet(); break;
                case "vertex": Vertex(words); break;
                case "outer":
                case "endloop": Require(_inFacet, StlMessages.EndLoop); break;
                default: throw Error(StlMessages.NotAKeyword(Shortened(words[0])));
            }
        }

        void BeginFacet()
        {
            Require(_inSolid && !_inFacet, StlMessages.FacetOutside);
            if (++_facets > StlReader.MaxTriangles) throw StlReader.TooMany(Here, _facets);
            _inFacet = true;
            _read = 0;
        }

        void EndFacet()
        {
            Require(_inFacet, StlMessages.EndFacet);
            Require(_read == 3, StlMessages.Corners(_read));
            _inFacet = false;
            _triangles.Add(_corners);
        }

        void Vertex(string[] words)
        {
            Require(_inFacet, StlMessages.VertexOutside);
            Require(_read < 3, StlMessages.FourthCorner);
            Require(words.Length == 4, StlMessages.VertexNumbers(words.Length - 1));
            for (var i = 0; i < 3; i++) _corners[3 * _read + i] = Number(words[i + 1]);
            _read++;
        }

        void End()
        {
            if (_inSolid) throw Error(StlMessages.NoEndSolid);
        }

        float Number(string word)
        {
            if (!float.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out var number)
                || float.IsNaN(number) || float.IsInfinity(number))
                throw Error(StlMessages.NotANumber(Shortened(word)));
            return number;
        }

        void Require(bool holds, string otherwise)
        {
            if (!holds) throw Error(otherwise);
        }

        string Here => _sourceName + ":" + _line;

        InputException Error(string message) => new InputException(Here + ": " + message);

        static string Shortened(string word)
        {
            var text = new StringBuilder(word, 0, Math.Min(word.Length, MaxQuoteLength), MaxQuoteLength + 1);
            for (var i = 0; i < text.Length; i++) if (char.IsControl(text[i])) text[i] = ' ';
            return text.Append(word.Length > MaxQuoteLength ? "…" : "").ToString();
        }
    }
}
