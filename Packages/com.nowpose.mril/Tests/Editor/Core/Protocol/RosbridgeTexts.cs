using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Protocol
{
    /// <summary>Creates rosbridge messages as strings and checks how the reader reads them.</summary>
    static class RosbridgeTexts
    {
        public const string Stamp = "\"header\":{\"stamp\":{\"sec\":12,\"nanosec\":345678900},\"frame_id\":\"\"}";

        public static string Publish(string msg, string topic = "/joint_states") =>
            "{\"op\":\"publish\",\"topic\":\"" + topic + "\",\"msg\":" + msg + "}";

        public static string State(string name, string position, string rest = "") =>
            Publish("{" + Stamp + ",\"name\":" + name + ",\"position\":" + position + rest + "}");

        public static RosbridgeMessage Read(string text)
        {
            var isRead = RosbridgeReader.TryRead(text, out var message, out var reason);
            Assert.That(isRead, Is.True, reason + ": " + text.Substring(0, System.Math.Min(200, text.Length)));
            Assert.That(reason, Is.EqualTo(DropReason.None));
            return message;
        }

        public static void Refuse(string text, DropReason expected)
        {
            Assert.That(RosbridgeReader.TryRead(text, out _, out var reason), Is.False, text.Substring(0, System.Math.Min(200, text.Length)));
            Assert.That(reason, Is.EqualTo(expected));
        }
    }
}
