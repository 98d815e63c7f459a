using System;
using System.Collections.Generic;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Recording
{
    /// <summary>Values of a line with the drops since the start, by reason.</summary>
    static class DropsLine
    {
        public static readonly EnumNames<DropReason> Reasons = new EnumNames<DropReason>(reason => (int)reason);
        public static readonly EnumNames<SyncExchangeFault> Faults = new EnumNames<SyncExchangeFault>(fault => (int)fault);

        public static int Count => Reasons.Names.Count + Faults.Names.Count;

        public static void Fill(CompensationSession session, double[] numbers)
        {
            Fill(session.Drops, numbers);
            for (var i = 0; i < Faults.Names.Count; i++) numbers[Reasons.Names.Count + i] = session.SyncFaults[(SyncExchangeFault)i];
        }

        /// <summary>Fills in only the counts of dropped messages.</summary>
        public static void Fill(DropCounters drops, double[] numbers)
        {
            for (var i = 0; i < Reasons.Names.Count; i++) numbers[i] = drops[(DropReason)i];
        }

        public static void Write(JsonLine line, ReadOnlySpan<double> numbers)
        {
            Write(line, "messages", Reasons.Names, numbers);
            Write(line, "exchanges", Faults.Names, numbers.Slice(Reasons.Names.Count));
        }

        static void Write(JsonLine line, string name, IReadOnlyList<string> names, ReadOnlySpan<double> counts)
        {
            line.Open(name, '{');
            for (var i = 0; i < names.Count; i++)
                if (counts[i] > 0) line.Add(names[i], (long)counts[i]);
            line.Close('}');
        }
    }
}
