using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;

namespace Nowpose.Latency
{
    /// <summary>Reads what <see cref="SweepLog"/> wrote; whatever is wrong is one line with file, line and field.</summary>
    public static class SweepLogReader
    {
        const string Nanoseconds = "control_ns", Vertices = "vertices", RenderMs = "render_ms", Source = "source", DisplayHz = "display_hz";

        static readonly int Columns = SweepLog.Header.Split(',').Length;

        /// <exception cref="InputException">The file cannot be read, is not of that form, or has no rows.</exception>
        public static IReadOnlyList<SweepRow> Read(string path)
        {
            try
            {
                using (var reader = new StreamReader(path)) return Read(reader, path);
            }
            catch (Exception fault) when (fault is IOException || fault is UnauthorizedAccessException || fault is ArgumentException)
            {
                throw new InputException(path + ": cannot be read: " + fault.Message.Replace('\r', ' ').Replace('\n', ' '), fault);
            }
        }

        /// <param name="name">Of the text, for messages.</param>
        /// <exception cref="InputException">Not of that form, or no rows.</exception>
        public static IReadOnlyList<SweepRow> Read(TextReader text, string name)
        {
            var header = text.ReadLine();
            if (header == null || header.Trim() != SweepLog.Header)
                throw new InputException(name + ":1: the header is '" + header + "'; that of a sweep log is " + SweepLog.Header);
            var rows = new List<SweepRow>();
            var fields = new List<string>();
            var device = "";
            var line = 2;
            for (var row = text.ReadLine(); row != null; row = text.ReadLine(), line++)
            {
                if (row.Length == 0) continue;
                CsvFields.Split(row, fields);
                rows.Add(RowOf(fields, name + ":" + line.ToString(CultureInfo.InvariantCulture), ref device));
            }
            if (rows.Count == 0) throw new InputException(name + ": no rows below the header; a sweep has one for each frame");
            return rows;
        }

        /// <param name="device">That of the row before: a name that stays the same is kept once.</param>
        static SweepRow RowOf(List<string> fields, string place, ref string device)
        {
            if (fields.Count != Columns) throw new InputException(place + ": " + fields.Count + " fields; there must be " + Columns);
            if (fields[4] != device) device = fields[4];
            try
            {
                return new SweepRow(
                    ControlTime.FromNanoseconds(Whole(fields[0], Nanoseconds, "nanoseconds")),
                    (int)Math.Min(Whole(fields[1], Vertices, "vertices"), int.MaxValue),
                    fields[2].Length == 0 ? (double?)null : Number(fields[2], RenderMs, "milliseconds"),
                    SourceOf(fields[3]),
                    device,
                    fields[5].Length == 0 ? double.NaN : Number(fields[5], DisplayHz, "hertz"));
            }
            catch (InputException fault)
            {
                throw new InputException(place + ": " + fault.Message, fault);
            }
        }

        static RenderTimeSourceKind SourceOf(string text)
        {
            if (RenderTimeSourceNames.TryParse(text, out var source)) return source;
            throw new InputException(
                Source + ": '" + text + "' is no source of a render time; known are " + RenderTimeSourceNames.All + ", or nothing");
        }

        static long Whole(string text, string field, string unit)
        {
            if (long.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var number)) return number;
            throw new InputException(field + ": '" + text + "' is not a whole number of " + unit);
        }

        static double Number(string text, string field, string unit)
        {
            if (double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out var number)) return number;
            throw new InputException(field + ": '" + text + "' is not a number of " + unit);
        }
    }
}
