using System;

namespace Nowpose.Messages
{
    /// <summary>Error messages about invalid arguments of methods that write or read protocol messages.</summary>
    static class ProtocolMessages
    {
        public static string PositionCount(int positions, int joints) =>
            $"{positions} positions were passed for {joints} joints; pass one position for each joint";

        public static string VelocityCount(int velocities, int joints) =>
            $"{velocities} velocities were passed for {joints} joints; pass one velocity for each joint, or none";

        public static string AccelerationCount(int accelerations, int joints) =>
            $"{accelerations} accelerations were passed for {joints} joints; pass one acceleration for each joint, or none";

        public static string NotFinite(string name, double value) =>
            FormattableString.Invariant($"{name} contains {value}, which JSON cannot represent; allowed: finite values");

        public static string TokenLength(int bytes, int max) => $"token: {bytes} bytes of UTF-8; allowed: 1 to {max}";
    }
}
