using System;
using Newtonsoft.Json;

namespace Nowpose.Protocol.Cell
{
    /// <summary>tf2_msgs/TFMessage: poses of frames, each with its own stamp. May contain a subset of the cell's frames, each child once.</summary>
    /// <remarks>A message from a <see cref="RosbridgeReader"/> is reused after <see cref="Release"/>.</remarks>
    sealed class TransformsMessage : IRosMessage
    {
        readonly MessagePool<TransformsMessage> _pool;
        FrameTransform[] _transforms;

        public TransformsMessage(params FrameTransform[] transforms)
        {
            _transforms = transforms;
            Count = transforms.Length;
        }

        /// <summary>Constructs an empty message that <see cref="Release"/> returns to a pool.</summary>
        public TransformsMessage(MessagePool<TransformsMessage> pool)
            : this() => _pool = pool;

        /// <summary>Number of transforms.</summary>
        public int Count { get; private set; }

        public ref readonly FrameTransform this[int index] => ref _transforms[index];

        /// <summary>Returns whether two messages have the same children in the same order.</summary>
        public static bool HaveSameFrames(TransformsMessage a, TransformsMessage b)
        {
            var isSame = a.Count == b.Count;
            for (var i = 0; isSame && i < a.Count; i++) isSame = a[i].Child == b[i].Child;
            return isSame;
        }

        public void Clear() => Count = 0;

        public void Add(in FrameTransform transform)
        {
            if (Count == _transforms.Length) Array.Resize(ref _transforms, Math.Max(4, 2 * Count));
            _transforms[Count++] = transform;
        }

        /// <summary>Replaces the stamp of one transform.</summary>
        public void SetStamp(int index, ControlTime stamp) => _transforms[index] = _transforms[index].At(stamp);

        public void Write(JsonWriter json, RosTimeForm form)
        {
            json.WriteStartObject();
            json.StartArray("transforms");
            for (var i = 0; i < Count; i++) this[i].Write(json, form);
            json.WriteEndArray();
            json.WriteEndObject();
        }

        /// <summary>
        /// Returns the message to its reader for reuse. Only the last user may call it. Does nothing if no reader created the message.
        /// </summary>
        public void Release() => _pool?.Return(this);
    }
}
