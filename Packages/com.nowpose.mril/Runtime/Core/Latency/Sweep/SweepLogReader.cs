using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using Nowpose.Latency.Conditions;

namespace Nowpose.Latency.Sweep
{
    /// <summary>Reads files that <see cref="SweepLog"/> wrote. Errors are one line with file, line and field.</summary>
    static class SweepLogReader
    {
        const string Nanoseconds = "control_ns", Vertices = "vertices", RenderMs = "render_ms", Source = "source", DisplayHz = "display_hz";

        static readonly int Columns = SweepLog.Header.Split(',').Length;

        /// <exception cref="InputException">The file cannot be read, has another format, or has no rows.</exception>
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

        /// <param name="name">Name of the text in messages.</param>
        /// <exception cref="InputException">The text has another format or no rows.</exception>
        public static IReadOnlyList<SweepRow> Read(TextReader text, string name) => Read(text, name, out _);

        /// <param name="name">Name of the text in messages.</param>
        /// <param name="conditions">Conditions above the header, without device and display rate, which are in the rows.</param>
        /// <exception cref="InputException">The text has another format or no rows.</exception>
        public static IReadOnlyList<SweepRow> Read(TextReader text, string name, out DisplayConditions conditions)
        {
            var line = 1;
            var header = text.ReadLine();
            var values = new string[DisplayConditionNames.Count];
            for (; IsComment(header); header = text.ReadLine(), line++) TakeCondition(header, values);
            conditions = ConditionsOf(values, name);
            if (header == null || header.Trim() != SweepLog.Header)
                throw new InputException(Place(name, line) + ": the header is '" + header + "'; it must be " + SweepLog.Header);
            var rows = new List<SweepRow>();
            var fields = new List<string>();
            var device = "";
            line++;
            for (var row = text.ReadLine(); row != null; row = text.ReadLine(), line++)
            {
                if (row.Length == 0) continue;
                CsvFields.Split(row, fields);
                rows.Add(RowOf(fields, Place(name, line), ref device));
            }
            if (rows.Count == 0) throw new InputException(name + ": there are no rows below the header; a sweep log has one for each frame");
            return rows;
        }

        static string Place(string name, int line) => name + ":" + line.ToString(CultureInfo.InvariantCulture);

        static bool IsComment(string line) => line != null && line.StartsWith(SweepLog.ConditionPrefix, StringComparison.Ordinal);

        // Unknown fields, which newer versions may add, are ignored.
        static void TakeCondition(string line, string[] values)
        {
            var end = line.IndexOf(SweepLog.ConditionSeparator, StringComparison.Ordinal);
            if (end < 0) return;
            var field = line.Substring(SweepLog.ConditionPrefix.Length, end - SweepLog.ConditionPrefix.Length);
            if (DisplayConditionNames.TryParse(field, out var condition))
                values[(int)condition] = line.Substring(end + SweepLog.ConditionSeparator.Length).Trim();
        }

        static DisplayConditions ConditionsOf(string[] values, string name)
        {
            try
            {
                return DisplayConditions.Parse(condition => values[(int)condition]);
            }
            catch (InputException fault)
            {
                throw new InputException(name + ": " + fault.Message, fault);
            }
        }

        /// <param name="device">Device of the previous row; reused when it is equal, so that the string is stored once.</param>
        static SweepRow RowOf(List<string> fields, string place, ref string device)
        {
            if (fields.Count != Columns) throw new InputException(place + ": " + fields.Count + " fields; it must have " + Columns);
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
                Source + ": '" + text + "' is not a source of render times; allowed are " + RenderTimeSourceNames.All + ", or nothing");
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
