using System;
using System.Collections.Generic;

namespace Nowpose.Protocol.Cell
{
    /// <summary>Reads tf2_msgs/TFMessage. Allocates nothing if a source repeats its names and messages are released. Not thread-safe.</summary>
    sealed class TransformsReader
    {
        // Cache size: messages contain the names of children and of their parents, which may be links of robots or the world.
        const int Names = 4 * ProtocolLimits.Frames;

        /// <summary>Maximum magnitude of a coordinate, m. It is far outside a cell, and single precision still resolves 0.1 m there.</summary>
        internal const double MaxCoordinate = 1e6;

        static readonly JsonNames MessageFields = new JsonNames("transforms");
        static readonly JsonNames StampedFields = new JsonNames("header", "child_frame_id", "transform");
        static readonly JsonNames TransformFields = new JsonNames("translation", "rotation");
        static readonly JsonNames VectorFields = new JsonNames("x", "y", "z");
        static readonly JsonNames QuaternionFields = new JsonNames("x", "y", "z", "w");

        readonly JsonNameCache _names = new JsonNameCache(Names);
        readonly MessagePool<TransformsMessage> _pool = new MessagePool<TransformsMessage>();
        // Translation and rotation of the transform that is being read.
        readonly double[] _pose = new double[7];
        readonly HashSet<string> _children = new HashSet<string>(StringComparer.Ordinal);

        /// <param name="isStatic">Whether stamps may be zero, because the pose of a stationary frame is valid at all times.</param>
        /// <returns>Null if the message is rejected.</returns>
        public TransformsMessage Read(ref JsonUtf8Reader json, bool isStatic)
        {
            if (!_pool.TryTake(out var message)) message = new TransformsMessage(_pool);
            message.Clear();
            _children.Clear();
            if (ReadMessage(ref json, message, isStatic)) return message;
            message.Release();
            return null;
        }

        bool ReadMessage(ref JsonUtf8Reader json, TransformsMessage into, bool isStatic)
        {
            var seen = 0;
            if (!json.BeginObject()) return false;
            while (json.NextField(MessageFields, ref seen, out _))
            {
                if (!json.BeginArray()) return false;
                while (json.NextElement())
                {
                    if (into.Count == ProtocolLimits.Frames) return json.Fail(DropReason.TooManyFrames);
                    if (ReadTransform(ref json, isStatic, out var transform)) into.Add(transform);
                }
            }

            return json.EndObject(seen, 1) && (into.Count > 0 || json.Fail(DropReason.MissingField));
        }

        bool ReadTransform(ref JsonUtf8Reader json, bool isStatic, out FrameTransform transform)
        {
            transform = default;
            var stamp = default(ControlTime);
            string parent = null, child = null;
            var seen = 0;
            if (!json.BeginObject()) return false;
            while (json.NextField(StampedFields, ref seen, out var field))
            {
                switch (field)
                {
                    case 0: RosTime.ReadFrameHeader(ref json, _names, isStatic, out stamp, out parent); break;
                    case 1: json.Name(_names, out child); break;
                    default: ReadPose(ref json, _pose); break;
                }
            }

            if (!json.EndObject(seen, 0b111)) return false;
            var pose = _pose;
            if (!FrameTransform.TryNormalise(ref pose[3], ref pose[4], ref pose[5], ref pose[6])) return json.Fail(DropReason.NotUnitQuaternion);
            if (child == parent) return json.Fail(DropReason.OwnParent);
            if (!_children.Add(child)) return json.Fail(DropReason.DuplicateName);
            transform = new FrameTransform(stamp, parent, child, pose[0], pose[1], pose[2], pose[3], pose[4], pose[5], pose[6]);
            return true;
        }

        static bool ReadPose(ref JsonUtf8Reader json, double[] pose)
        {
            var seen = 0;
            if (!json.BeginObject()) return false;
            while (json.NextField(TransformFields, ref seen, out var field))
            {
                if (field == 0) ReadNumbers(ref json, VectorFields, pose, 0);
                else ReadNumbers(ref json, QuaternionFields, pose, 3);
            }

            return json.EndObject(seen, 0b11);
        }

        static bool ReadNumbers(ref JsonUtf8Reader json, JsonNames fields, double[] into, int first)
        {
            var seen = 0;
            if (!json.BeginObject()) return false;
            while (json.NextField(fields, ref seen, out var field))
            {
                if (!json.FiniteNumber(out into[first + field])) continue;
                if (fields == VectorFields && Math.Abs(into[first + field]) > MaxCoordinate) json.Fail(DropReason.OutOfRange);
            }
            return json.EndObject(seen, fields == VectorFields ? 0b111 : 0b1111);
        }
    }
}
