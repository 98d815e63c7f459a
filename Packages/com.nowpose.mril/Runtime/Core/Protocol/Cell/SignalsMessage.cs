using System;
using Newtonsoft.Json;

namespace Nowpose.Protocol.Cell
{
    /// <summary>
    /// nowpose_msgs/Signals: states of actuators and sensors that are valid from one control time on. May contain a subset of the cell's signals,
    /// each once.
    /// </summary>
    /// <remarks>A message from a <see cref="RosbridgeReader"/> is reused after <see cref="Release"/>.</remarks>
    sealed class SignalsMessage : IRosMessage
    {
        readonly MessagePool<SignalsMessage> _pool;
        SignalValue[] _values;

        public SignalsMessage(ControlTime stamp, params SignalValue[] values)
        {
            Stamp = stamp;
            _values = values;
            Count = values.Length;
        }

        /// <summary>Constructs an empty message that <see cref="Release"/> returns to a pool.</summary>
        public SignalsMessage(MessagePool<SignalsMessage> pool)
            : this(default(ControlTime)) => _pool = pool;

        /// <summary>Time of the control cycle in which the signals changed or were sampled, on the control clock C1.</summary>
        public ControlTime Stamp { get; set; }

        /// <summary>Number of signals.</summary>
        public int Count { get; private set; }

        public ref readonly SignalValue this[int index] => ref _values[index];

        public void Clear() => Count = 0;

        public void Add(in SignalValue value)
        {
            if (Count == _values.Length) Array.Resize(ref _values, Math.Max(4, 2 * Count));
            _values[Count++] = value;
        }

        public void Write(JsonWriter json, RosTimeForm form)
        {
            json.WriteStartObject();
            json.Header(Stamp, form);
            json.StartArray("name");
            for (var i = 0; i < Count; i++) json.WriteValue(this[i].Name);
            json.WriteEndArray();
            json.StartArray("value");
            for (var i = 0; i < Count; i++) json.Finite("value", this[i].Value);
            json.WriteEndArray();
            json.WriteEndObject();
        }

        /// <summary>
        /// Returns the message to its reader for reuse. Only the last user may call it. Does nothing if no reader created the message.
        /// </summary>
        public void Release() => _pool?.Return(this);
    }

    /// <summary>Value of one signal of the plant.</summary>
    readonly struct SignalValue
    {
        /// <param name="value">See <see cref="Value"/>.</param>
        public SignalValue(string name, double value) => (Name, Value) = (name, value);

        public string Name { get; }

        /// <summary>Finite value; 0 or 1 for a Boolean signal.</summary>
        public double Value { get; }
    }
}
