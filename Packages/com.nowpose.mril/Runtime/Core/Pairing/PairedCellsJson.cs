using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text;
using Newtonsoft.Json;
using Nowpose.Messages;
using Nowpose.Protocol;

namespace Nowpose.Pairing
{
    /// <summary>Paired cells as JSON text, version 1: the exact codes of their markers, and the tokens.</summary>
    static class PairedCellsJson
    {
        const string Format = "nowpose-paired-cells";
        const int Version = 1, Nesting = 6;

        static readonly JsonNames FileFields = new JsonNames("format", "version", "used", "cells"), CellFields = new JsonNames("codes", "token");

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

        /// <param name="name">Name of the input in messages, such as a file name.</param>
        /// <exception cref="InputException">
        /// The text has another format, a newer version, or an invalid value. The message never contains a token.
        /// </exception>
        public static PairedCells Read(string text, string name)
        {
            try
            {
                var utf8 = Encoding.UTF8.GetBytes(text);
                if (JsonUtf8Reader.Check(utf8, Nesting) != DropReason.None) throw new InputException(PairedCellMessages.NotComplete);
                return Read(new JsonUtf8Reader(utf8, Nesting));
            }
            catch (InputException fault)
            {
                throw new InputException(PairedCellMessages.Unusable(name, fault.Message), fault);
            }
        }

        static PairedCells Read(JsonUtf8Reader json)
        {
            string used = null;
            var cells = new List<PairedCell>();
            var seen = 0;
            json.BeginObject();
            while (json.NextField(FileFields, ref seen, out var field))
            {
                switch (field)
                {
                    case 0 when json.Text(out var format): RequireFormat(format); break;
                    case 1 when json.Integer(out var version): RequireVersion(version); break;
                    case 2: json.OptionalText(out used); break;
                    case 3: ReadCells(ref json, cells); break;
                }
            }

            return json.EndObject(seen, 0b1011)
                ? new PairedCells(cells, used) : throw new InputException(PairedCellMessages.Field(json.Fault));
        }

        static void RequireFormat(string format)
        {
            if (format != Format) throw new InputException(PairedCellMessages.OtherFormat(Format));
        }

        static void RequireVersion(long version)
        {
            if (version != Version)
                throw new InputException(PairedCellMessages.NewerVersion(version, Version));
        }

        static void ReadCells(ref JsonUtf8Reader json, List<PairedCell> into)
        {
            json.BeginArray();
            while (json.NextElement() && ReadCell(ref json, out var cell)) into.Add(cell);
        }

        static bool ReadCell(ref JsonUtf8Reader json, out PairedCell cell)
        {
            cell = null;
            var codes = new List<CellCode>();
            string token = null;
            var seen = 0;
            json.BeginObject();
            while (json.NextField(CellFields, ref seen, out var field))
                if (field == 0) ReadCodes(ref json, codes);
                else json.OptionalText(out token);
            if (!json.EndObject(seen, 1)) return false;
            cell = new PairedCell(codes, token);
            return true;
        }

        static void ReadCodes(ref JsonUtf8Reader json, List<CellCode> into)
        {
            json.BeginArray();
            while (json.NextElement() && json.Text(out var text)) into.Add(CellCode.Parse(text));
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
