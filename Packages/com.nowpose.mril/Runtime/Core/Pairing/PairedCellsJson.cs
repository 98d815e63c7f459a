using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using Newtonsoft.Json;
using Nowpose.Protocol;

namespace Nowpose.Pairing
{
    /// <summary>Paired cells as JSON text, version 1: the codes of their markers as they are printed, and the tokens.</summary>
    static class PairedCellsJson
    {
        const string Format = "nowpose-paired-cells";
        const int Version = 1, Nesting = 6;

        static readonly string[] FileFields = { "format", "version", "used", "cells" }, CellFields = { "codes", "token" };

        public static string Write(PairedCells cells)
        {
            var text = new StringWriter(CultureInfo.InvariantCulture) { NewLine = "\n" };
            using var json = new JsonTextWriter(text) { Formatting = Formatting.Indented };
            json.WriteStartObject();
            Add(json, "format", Format);
            Add(json, "version", Version);
            Add(json, "used", cells.Used?.Cell);
            json.WritePropertyName("cells");
            json.WriteStartArray();
            foreach (var cell in cells.All) Write(json, cell);
            json.WriteEndArray();
            json.WriteEndObject();
            json.Flush();
            return text + "\n";
        }

        /// <param name="name">Stands for the text in messages: a file's name.</param>
        /// <exception cref="InputException">No such text, one of a newer version, or a value that cannot be used. Never holds a token.</exception>
        public static PairedCells Read(string text, string name)
        {
            try
            {
                if (JsonSyntax.Check(text, Nesting) != DropReason.None) throw new InputException("no JSON object, or cut off");
                using (var cursor = new JsonCursor(text)) return Read(cursor);
            }
            catch (Exception fault) when (fault is InputException || fault is JsonException)
            {
                throw new InputException(name + ": no paired cells that can be used: " + fault.Message, fault);
            }
        }

        static PairedCells Read(JsonCursor cursor)
        {
            string format = null, used = null;
            long version = 0;
            var cells = new List<PairedCell>();
            var isRead = cursor.Object(FileFields, 0b1011, field =>
            {
                switch (field)
                {
                    case 0: return cursor.Text(out format) && RequireFormat(format);
                    case 1: return cursor.Integer(out version) && RequireVersion(version);
                    case 2: return cursor.OptionalText(out used);
                    default: return cursor.Elements(() => Add(cells, cursor));
                }
            });
            return isRead
                ? new PairedCells(cells, used) : throw new InputException("a field is missing, twice, or of another kind (" + cursor.Fault + ")");
        }

        static bool RequireFormat(string format) => format == Format ? true : throw new InputException("another format than '" + Format + "'");

        static bool RequireVersion(long version) => version == Version
            ? true : throw new InputException("version " + version + ", this Nowpose reads version " + Version + "; update Nowpose");

        static bool Add(List<PairedCell> cells, JsonCursor cursor)
        {
            var codes = new List<CellCode>();
            string token = null;
            if (!cursor.Object(CellFields, 1, field => field == 0
                ? cursor.Elements(() => Add(codes, cursor)) : cursor.OptionalText(out token))) return false;
            cells.Add(new PairedCell(codes, token));
            return true;
        }

        static bool Add(List<CellCode> codes, JsonCursor cursor)
        {
            if (!cursor.Text(out var text)) return false;
            codes.Add(CellCode.Parse(text));
            return true;
        }

        static void Write(JsonTextWriter json, PairedCell cell)
        {
            json.WriteStartObject();
            json.WritePropertyName("codes");
            json.WriteStartArray();
            foreach (var code in cell.Codes) json.WriteValue(code.Text);
            json.WriteEndArray();
            Add(json, "token", cell.Token);
            json.WriteEndObject();
        }

        static void Add(JsonTextWriter json, string name, object value)
        {
            json.WritePropertyName(name);
            json.WriteValue(value);
        }
    }
}
