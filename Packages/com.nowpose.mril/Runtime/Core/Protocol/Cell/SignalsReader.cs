using System;
using System.Collections.Generic;

namespace Nowpose.Protocol.Cell
{
    /// <summary>Reads nowpose_msgs/Signals. Allocates nothing if a source repeats its names and messages are released. Not thread-safe.</summary>
    sealed class SignalsReader
    {
        static readonly JsonNames Fields = new JsonNames("header", "name", "value");

        readonly JsonNameCache _cache = new JsonNameCache(2 * ProtocolLimits.Signals);
        readonly MessagePool<SignalsMessage> _pool = new MessagePool<SignalsMessage>();
        readonly HashSet<string> _known = new HashSet<string>(StringComparer.Ordinal);
        readonly List<string> _names = new List<string>();
        readonly List<double> _values = new List<double>();

        /// <returns>Null if the message is rejected.</returns>
        public SignalsMessage Read(ref JsonUtf8Reader json)
        {
            var stamp = default(ControlTime);
            var seen = 0;
            _known.Clear();
            _names.Clear();
            _values.Clear();
            if (!json.BeginObject()) return null;
            while (json.NextField(Fields, ref seen, out var field))
            {
                switch (field)
                {
                    case 0: RosTime.ReadHeader(ref json, out stamp); break;
                    case 1: ReadNames(ref json); break;
                    default: json.Numbers(_values, areOptional: false, DropReason.TooManySignals); break;
                }
            }

            if (!json.EndObject(seen, 0b111)) return null;
            if (_values.Count != _names.Count) json.Fail(DropReason.LengthMismatch);
            else if (_names.Count == 0) json.Fail(DropReason.MissingField);
            return json.Fault == DropReason.None ? Filled(stamp) : null;
        }

        SignalsMessage Filled(ControlTime stamp)
        {
            if (!_pool.TryTake(out var message)) message = new SignalsMessage(_pool);
            message.Clear();
            message.Stamp = stamp;
            for (var i = 0; i < _names.Count; i++) message.Add(new SignalValue(_names[i], _values[i]));
            return message;
        }

        bool ReadNames(ref JsonUtf8Reader json)
        {
            if (!json.BeginArray()) return false;
            while (json.NextElement() && json.Name(_cache, out var name))
            {
                if (_names.Count == ProtocolLimits.Signals) return json.Fail(DropReason.TooManySignals);
                if (!_known.Add(name)) return json.Fail(DropReason.DuplicateName);
                _names.Add(name);
            }

            return json.Fault == DropReason.None;
        }
    }
}
