using System;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Recording
{
    /// <summary>Values of a line with the drops since the start, by reason.</summary>
    static class DropsLine
    {
        static readonly LineNames Reasons = new LineNames(typeof(DropReason));
        static readonly LineNames Faults = new LineNames(typeof(SyncExchangeFault));

        public static int Count => Reasons.Count + Faults.Count;

        public static void Fill(CompensationSession session, double[] numbers)
        {
            Fill(session.Drops, numbers);
            for (var i = 0; i < Faults.Count; i++) numbers[Reasons.Count + i] = session.SyncFaults[(SyncExchangeFault)i];
        }

        /// <summary>Fills in only the counts of dropped messages.</summary>
        public static void Fill(DropCounters drops, double[] numbers)
        {
            for (var i = 0; i < Reasons.Count; i++) numbers[i] = drops[(DropReason)i];
        }

        public static void Write(JsonLine line, ReadOnlySpan<double> numbers)
        {
            Write(line, "messages", Reasons, numbers);
            Write(line, "exchanges", Faults, numbers.Slice(Reasons.Count));
        }

        static void Write(JsonLine line, string name, LineNames names, ReadOnlySpan<double> counts)
        {
            line.Open(name, '{');
            for (var i = 0; i < names.Count; i++)
                if (counts[i] > 0) line.Add(names[i], (long)counts[i]);
            line.Close('}');
        }
    }
}
