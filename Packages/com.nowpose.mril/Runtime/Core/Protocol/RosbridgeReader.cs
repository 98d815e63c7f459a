using System;
using System.Text;
using Newtonsoft.Json;

namespace Nowpose.Protocol
{
    /// <summary>Reads rosbridge v2 messages and holds them to every rule that needs no clock and no role.</summary>
    /// <remarks>
    /// A token reader: no reflection, so it runs under IL2CPP. Unknown fields are skipped; a known field given twice is refused.
    /// Any thread; keeps nothing. Whether a stamp lies in the future is <see cref="StampRule"/>'s, with the caller's clock.
    /// </remarks>
    public static class RosbridgeReader
    {
        static readonly string[] Fields =
        {
            "op", "id", "topic", "type", "service", "throttle_rate", "queue_length", "level", "msg", "result",
        };

        static readonly string[] Publication = { "msg" };
        static readonly string[] Response = { "values" };

        /// <summary>Reads one message; never throws for what came over the wire.</summary>
        /// <param name="message">
        /// The message. When it is refused: what could be read of its envelope, so that a status can name it, or null.
        /// </param>
        public static bool TryRead(string text, out RosbridgeMessage message, out DropReason reason)
        {
            message = null;
            reason = IsLonger(text, ProtocolLimits.DescriptionBytes)
                ? DropReason.TooLarge : JsonSyntax.Check(text, ProtocolLimits.Nesting);
            if (reason != DropReason.None)
                return false;
            try
            {
                reason = Read(text, ref message);
            }
            catch (Exception e) when (e is JsonException || e is OverflowException || e is FormatException)
            {
                // Numbers no double or integer holds: what the reader does with them differs between runtimes.
                reason = DropReason.OutOfRange;
            }

            return reason == DropReason.None;
        }

        static DropReason Read(string text, ref RosbridgeMessage message)
        {
            using var cursor = new JsonCursor(text);
            var envelope = new RosbridgeMessage { Result = true };
            if (!cursor.Object(Fields, 1, field => ReadField(cursor, field, envelope)))
                return cursor.Fault;
            message = envelope;
            if (envelope.Topic != RosTopics.RobotDescription && IsLonger(text, ProtocolLimits.MessageBytes))
                return DropReason.TooLarge;
            var missing = Missing(envelope);
            return missing == DropReason.None ? ReadBody(text, envelope) : missing;
        }

        static bool ReadField(JsonCursor cursor, int field, RosbridgeMessage into)
        {
            string text;
            bool isRead;
            switch (Fields[field])
            {
                case "op": isRead = cursor.Text(out text); into.Op = OpOf(text); into.OpName = text; return isRead;
                case "id": isRead = cursor.OptionalText(out text); into.Id = text; return isRead;
                case "topic": isRead = cursor.OptionalText(out text); into.Topic = text; return isRead;
                case "type": isRead = cursor.OptionalText(out text); into.Type = text; return isRead;
                case "service": isRead = cursor.OptionalText(out text); into.Service = text; return isRead;
                case "level": isRead = cursor.OptionalText(out text); into.Level = text; return isRead;
                case "throttle_rate": isRead = cursor.OptionalCount(out var rate); into.ThrottleRateMs = rate; return isRead;
                case "queue_length": isRead = cursor.OptionalCount(out var length); into.QueueLength = length; return isRead;
                case "result": isRead = cursor.Flag(out var result); into.Result = result; return isRead;
                default: return ReadMsg(cursor, into);
            }
        }

        // The words of a status, or the body of a publication, which is read once its topic is known.
        static bool ReadMsg(JsonCursor cursor, RosbridgeMessage into)
        {
            if (!cursor.IsText)
                return cursor.Skip();
            var isRead = cursor.Text(out var text);
            into.Text = text;
            return isRead;
        }

        static RosbridgeOp OpOf(string name)
        {
            switch (name)
            {
                case "subscribe": return RosbridgeOp.Subscribe;
                case "unsubscribe": return RosbridgeOp.Unsubscribe;
                case "advertise": return RosbridgeOp.Advertise;
                case "unadvertise": return RosbridgeOp.Unadvertise;
                case "publish": return RosbridgeOp.Publish;
                case "call_service": return RosbridgeOp.CallService;
                case "service_response": return RosbridgeOp.ServiceResponse;
                case "advertise_service": return RosbridgeOp.AdvertiseService;
                case "unadvertise_service": return RosbridgeOp.UnadvertiseService;
                case "status": return RosbridgeOp.Status;
                case "set_level": return RosbridgeOp.SetLevel;
                default: return RosbridgeOp.Unknown;
            }
        }

        static DropReason Missing(RosbridgeMessage message)
        {
            switch (message.Op)
            {
                case RosbridgeOp.Unknown: return DropReason.UnknownOp;
                case RosbridgeOp.CallService:
                case RosbridgeOp.AdvertiseService:
                case RosbridgeOp.UnadvertiseService:
                case RosbridgeOp.ServiceResponse: return Need(message.Service);
                case RosbridgeOp.Status: return Need(message.Text);
                case RosbridgeOp.SetLevel: return Need(message.Level);
                default: return Need(message.Topic);
            }
        }

        static DropReason Need(string field) => string.IsNullOrEmpty(field) ? DropReason.MissingField : DropReason.None;

        // A second walk: the body may stand before the topic that says what it is.
        static DropReason ReadBody(string text, RosbridgeMessage into)
        {
            var name = into.Op == RosbridgeOp.Publish ? Publication : into.Op == RosbridgeOp.ServiceResponse ? Response : null;
            if (name == null)
                return DropReason.None;
            using var cursor = new JsonCursor(text);
            cursor.Object(name, into.Op == RosbridgeOp.Publish ? 1 : 0, _ => RosMessages.Read(cursor, into));
            return cursor.Fault;
        }

        static bool IsLonger(string text, int limitBytes) =>
            // A UTF-16 code unit takes 1 to 3 bytes: most messages are decided without counting.
            text.Length > limitBytes || (text.Length > limitBytes / 3 && Encoding.UTF8.GetByteCount(text) > limitBytes);
    }
}
