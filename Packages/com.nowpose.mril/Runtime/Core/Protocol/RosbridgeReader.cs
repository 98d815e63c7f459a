using System;
using System.Collections.Generic;
using System.Text;

namespace Nowpose.Protocol
{
    /// <summary>Reads rosbridge v2 messages and checks all rules that depend neither on a clock nor on the role of the receiver.</summary>
    /// <remarks>
    /// Reads the received bytes in one pass, see <see cref="JsonUtf8Reader"/>; without reflection, so it runs under IL2CPP. Unknown fields
    /// are skipped; a duplicate known field is rejected. It caches the joint names of the newest sources, so that a source that repeats
    /// its names causes no allocation. <see cref="StampRule"/> checks with the caller's clock whether a stamp is in the future. Not
    /// thread-safe.
    /// </remarks>
    sealed class RosbridgeReader
    {
        /// <summary>Maximum number of cached topic names: enough for the topics of all robots and of the cell.</summary>
        const int MaxTopics = 4 * ProtocolLimits.Robots;

        // The names are in the order of RosbridgeOp, without its first value.
        static readonly JsonNames Ops = new JsonNames(
            "subscribe", "unsubscribe", "advertise", "unadvertise", "publish", "call_service", "service_response", "advertise_service",
            "unadvertise_service", "status", "set_level");

        static readonly JsonNames Fields = new JsonNames(
            "op", "topic", "id", "service", "msg", "type", "throttle_rate", "queue_length", "level", "result");

        // The first of these fields.
        static readonly JsonNames Identity = new JsonNames("op", "topic", "id", "service");

        static readonly JsonNames Publication = new JsonNames("msg");
        static readonly JsonNames Response = new JsonNames("values");

        readonly RosMessageReader _bodies = new RosMessageReader();
        readonly JsonNameCache _topicNames = new JsonNameCache(MaxTopics);
        readonly Dictionary<string, RobotTopic> _topics = new Dictionary<string, RobotTopic>(StringComparer.Ordinal);
        readonly RosbridgeMessage _message = new RosbridgeMessage();

        /// <summary>Reads one message from a string.</summary>
        /// <inheritdoc cref="TryRead(ReadOnlySpan{byte}, out RosbridgeMessage, out DropReason)"/>
        public static bool TryRead(string text, out RosbridgeMessage message, out DropReason reason) =>
            new RosbridgeReader().TryRead(Encoding.UTF8.GetBytes(text), out message, out reason);

        /// <summary>Reads one message; never throws for received data.</summary>
        /// <param name="message">
        /// The message, valid until the next call. For a rejected message, the readable part of its envelope, which is needed to report the
        /// fault; null if the message is not JSON.
        /// </param>
        public bool TryRead(ReadOnlySpan<byte> utf8, out RosbridgeMessage message, out DropReason reason)
        {
            message = null;
            reason = DropReason.TooLarge;
            if (utf8.Length > ProtocolLimits.DescriptionBytes) return false;
            reason = Read(utf8, isOnePass: true, out message);
            if (reason == DropReason.None) return true;
            // A rejected message is read again to find the fault with the highest priority: syntax, then envelope, then body.
            message = null;
            reason = JsonUtf8Reader.Check(utf8, ProtocolLimits.Nesting);
            if (reason != DropReason.None) return false;
            reason = Read(utf8, isOnePass: false, out message);
            message ??= Identify(utf8);
            return reason == DropReason.None;
        }

        // Reads the fields with which the sender recognises its message, although another field of the envelope cannot be read.
        RosbridgeMessage Identify(ReadOnlySpan<byte> utf8)
        {
            _message.Clear();
            var json = new JsonUtf8Reader(utf8, ProtocolLimits.Nesting);
            var seen = 0;
            json.BeginObject();
            while (json.NextField(Identity, ref seen, out var field))
                if (json.IsText || json.IsInteger && Fields[field] == "id") ReadField(ref json, field);
                else json.Skip();
            _message.Op = RosbridgeOp.Unknown;
            return _message;
        }

        // isOnePass: reads the body in place if it follows the topic, which determines its type. Nearly all messages have this order.
        DropReason Read(ReadOnlySpan<byte> utf8, bool isOnePass, out RosbridgeMessage message)
        {
            message = null;
            _message.Clear();
            var json = new JsonUtf8Reader(utf8, ProtocolLimits.Nesting);
            var isBodyRead = false;
            var seen = 0;
            json.BeginObject();
            while (json.NextField(Fields, ref seen, out var field))
                if (isOnePass && Fields[field] == "msg" && _message.Op == RosbridgeOp.Publish && _message.Topic != null && json.IsObject)
                    isBodyRead = _bodies.Read(ref json, _message);
                else ReadField(ref json, field);
            if (!json.EndObject(seen, 1) || !json.End()) return json.Fault;
            message = _message;
            if (_message.RobotTopic?.Kind != RosTopics.RobotDescription && utf8.Length > ProtocolLimits.MessageBytes) return DropReason.TooLarge;
            var missing = Missing(_message);
            return missing == DropReason.None && !isBodyRead ? ReadBody(utf8) : missing;
        }

        bool ReadField(ref JsonUtf8Reader json, int field)
        {
            string text;
            bool isRead;
            switch (Fields[field])
            {
                case "op": isRead = json.Text(Ops, out var op, out text); _message.Op = (RosbridgeOp)(op + 1); _message.OpName = text; return isRead;
                case "id": isRead = json.OptionalId(out var id); _message.Id = id; return isRead;
                case "topic": isRead = json.OptionalText(_topicNames, out text); SetTopic(text); return isRead;
                case "type": isRead = json.OptionalText(out text); _message.Type = text; return isRead;
                case "service": isRead = json.OptionalText(out text); _message.Service = text; return isRead;
                case "level": isRead = json.OptionalText(out text); _message.Level = text; return isRead;
                case "throttle_rate": isRead = json.OptionalCount(out var rate); _message.ThrottleRateMs = rate; return isRead;
                case "queue_length": isRead = json.OptionalCount(out var length); _message.QueueLength = length; return isRead;
                case "result": isRead = json.Flag(out var result); _message.Result = result; return isRead;
                default: return ReadMsg(ref json);
            }
        }

        void SetTopic(string name)
        {
            _message.Topic = name;
            if (name == null) return;
            if (!_topics.TryGetValue(name, out var topic))
            {
                if (_topics.Count == MaxTopics) _topics.Clear();
                _topics[name] = topic = RobotTopic.Parse(name);
            }

            _message.RobotTopic = topic;
        }

        // Reads the text of a status. Skips the body of a publication, which is read when its topic is known.
        bool ReadMsg(ref JsonUtf8Reader json)
        {
            if (!json.IsText) return json.Skip();
            var isRead = json.Text(out var text);
            _message.Text = text;
            return isRead;
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

        // Reads the body in a second pass if it precedes its topic, and for a service response, because its meaning depends on several fields.
        DropReason ReadBody(ReadOnlySpan<byte> utf8)
        {
            var isPublication = _message.Op == RosbridgeOp.Publish;
            if (!isPublication && _message.Op != RosbridgeOp.ServiceResponse) return DropReason.None;
            var json = new JsonUtf8Reader(utf8, ProtocolLimits.Nesting);
            var seen = 0;
            json.BeginObject();
            while (json.NextField(isPublication ? Publication : Response, ref seen, out _)) _bodies.Read(ref json, _message);
            json.EndObject(seen, isPublication ? 1 : 0);
            return json.Fault;
        }
    }
}
