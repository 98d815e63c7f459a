using System;

namespace Nowpose.Protocol
{
    /// <summary>Names of joint states on the wire: lower case.</summary>
    static class JointDataStateName
    {
        static readonly string[] Names = Array.ConvertAll(Enum.GetNames(typeof(JointDataState)), name => name.ToLowerInvariant());

        public static string Of(JointDataState state) => Names[(int)state];

        public static bool TryRead(string name, out JointDataState state)
        {
            var index = Array.IndexOf(Names, name);
            state = (JointDataState)index;
            return index >= 0;
        }
    }
}
