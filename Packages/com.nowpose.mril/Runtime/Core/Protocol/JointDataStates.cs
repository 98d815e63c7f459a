using System;

namespace Nowpose.Protocol
{
    /// <summary>Names of joint states on the wire (lower case), and which of them are good.</summary>
    static class JointDataStates
    {
        /// <summary>Names, indexed by the number of the state.</summary>
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
