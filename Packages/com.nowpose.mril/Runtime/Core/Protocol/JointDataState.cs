using System.Collections.Generic;

namespace Nowpose.Protocol
{
    /// <summary>State of one joint's data.</summary>
    public enum JointDataState
    {
        /// <summary>Samples of the joint arrive.</summary>
        Live,

        /// <summary>No samples arrive, but the control system still reports the same value: the joint is assumed to be at rest.</summary>
        Rest,

        /// <summary>Samples arrived before and have stopped for an unknown reason.</summary>
        Stale,

        /// <summary>Invalid values arrive, such as NaN or a bad OPC UA status.</summary>
        Refused,

        /// <summary>The data ended during a motion, the control system has not responded for too long, or the variable was removed.</summary>
        Fault,

        /// <summary>No usable value has arrived since the source started.</summary>
        Missing,
    }

    /// <summary>Names of joint states on the wire, in lower case, and the check whether a state is good.</summary>
    static class JointDataStates
    {
        static readonly EnumNames<JointDataState> Table = new EnumNames<JointDataState>(state => (int)state);

        /// <summary>Names in the order of the states.</summary>
        public static IReadOnlyList<string> Names => Table.Names;

        public static string Of(JointDataState state) => Table.NameOf(state);

        /// <summary>Returns whether the position of a joint in this state is known.</summary>
        public static bool IsGood(this JointDataState state) => state == JointDataState.Live || state == JointDataState.Rest;

        public static bool TryRead(string name, out JointDataState state) => Table.TryParse(name, out state);
    }
}
