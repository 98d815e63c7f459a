using System;

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
        /// <summary>Names, indexed by the numeric value of the state.</summary>
        public static readonly string[] Names = Array.ConvertAll(Enum.GetNames(typeof(JointDataState)), name => name.ToLowerInvariant());

        public static string Of(JointDataState state) => Names[(int)state];

        /// <summary>Returns whether the position of a joint in this state is known.</summary>
        public static bool IsGood(this JointDataState state) => state == JointDataState.Live || state == JointDataState.Rest;

        public static bool TryRead(string name, out JointDataState state)
        {
            var index = Array.IndexOf(Names, name);
            state = (JointDataState)index;
            return index >= 0;
        }
    }
}
