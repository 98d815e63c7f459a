using System;
using Newtonsoft.Json;
using Nowpose.Messages;
using Nowpose.Protocol.Cell;

namespace Nowpose.Protocol
{
    /// <summary>Writes the bodies of publications.</summary>
    static class RosMessageWriter
    {
        // Maximum number of bytes per UTF-16 code unit: a control or rare character is written as \uXXXX; others need at most 3 bytes of UTF-8.
        const int BytesPerCharacter = 6;

        const long NanosecondsPerSecond = 1_000_000_000;

        public static void Write(JsonWriter json, JointStateMessage message, RosTimeForm form)
        {
            json.WriteStartObject();
            Header(json, message.Stamp, form, message.FrameId);
            Texts(json, "name", message.Names);
            Positions(json, "position", message.Positions);
            OptionalNumbers(json, "velocity", message.Velocities);
            Positions(json, "effort", Array.Empty<double>());
            if (message.Accelerations != null) OptionalNumbers(json, "acceleration", message.Accelerations);
            json.WriteEndObject();
        }

        public static void Write(JsonWriter json, JointTrajectoryMessage message, RosTimeForm form)
        {
            json.WriteStartObject();
            Header(json, message.Stamp, form);
            Texts(json, "joint_names", message.Names);
            json.WritePropertyName("points");
            json.WriteStartArray();
            foreach (var point in message.Points)
                Write(json, point, form);
            json.WriteEndArray();
            json.WriteEndObject();
        }

        public static void Write(JsonWriter json, DiagnosticsMessage message, RosTimeForm form)
        {
            json.WriteStartObject();
            Header(json, message.Stamp, form);
            json.WritePropertyName("status");
            json.WriteStartArray();
            Status(json, message);
            json.WriteEndArray();
            json.WriteEndObject();
        }

        public static void Write(JsonWriter json, TransformsMessage message, RosTimeForm form)
        {
            json.WriteStartObject();
            json.WritePropertyName("transforms");
            json.WriteStartArray();
            for (var i = 0; i < message.Count; i++) Write(json, message[i], form);
            json.WriteEndArray();
            json.WriteEndObject();
        }

        public static void Write(JsonWriter json, SignalsMessage message, RosTimeForm form)
        {
            json.WriteStartObject();
            Header(json, message.Stamp, form);
            json.WritePropertyName("name");
            json.WriteStartArray();
            for (var i = 0; i < message.Count; i++) json.WriteValue(message[i].Name);
            json.WriteEndArray();
            json.WritePropertyName("value");
            json.WriteStartArray();
            for (var i = 0; i < message.Count; i++) Finite(json, "value", message[i].Value);
            json.WriteEndArray();
            json.WriteEndObject();
        }

        /// <param name="nanoseconds">Time since the epoch, or a length, in ns.</param>
        public static void Write(JsonWriter json, long nanoseconds, RosTimeForm form)
        {
            // The remainder is never negative: -0.25 s is -1 s and 750 000 000 ns.
            var rest = (nanoseconds % NanosecondsPerSecond + NanosecondsPerSecond) % NanosecondsPerSecond;
            json.WriteStartObject();
            json.WritePropertyName(form == RosTimeForm.Secs ? "secs" : "sec");
            json.WriteValue((nanoseconds - rest) / NanosecondsPerSecond);
            json.WritePropertyName(form == RosTimeForm.Secs ? "nsecs" : "nanosec");
            json.WriteValue(rest);
            json.WriteEndObject();
        }

        static void Write(JsonWriter json, JointTrajectoryPoint point, RosTimeForm form)
        {
            json.WriteStartObject();
            Positions(json, "positions", point.Positions);
            // Omits empty arrays: a long path with them could exceed the maximum length, although the received message did not.
            if (point.Velocities != null) OptionalNumbers(json, "velocities", point.Velocities);
            if (point.Accelerations != null) OptionalNumbers(json, "accelerations", point.Accelerations);
            json.WritePropertyName("time_from_start");
            Write(json, new ControlTime(point.TimeFromStart).Nanoseconds, form);
            json.WriteEndObject();
        }

        static void Write(JsonWriter json, in FrameTransform transform, RosTimeForm form)
        {
            json.WriteStartObject();
            Header(json, transform.Stamp, form, transform.Parent);
            Text(json, "child_frame_id", transform.Child);
            json.WritePropertyName("transform");
            json.WriteStartObject();
            json.WritePropertyName("translation");
            json.WriteStartObject();
            Number(json, "x", transform.X);
            Number(json, "y", transform.Y);
            Number(json, "z", transform.Z);
            json.WriteEndObject();
            json.WritePropertyName("rotation");
            json.WriteStartObject();
            Number(json, "x", transform.Qx);
            Number(json, "y", transform.Qy);
            Number(json, "z", transform.Qz);
            Number(json, "w", transform.Qw);
            json.WriteEndObject();
            json.WriteEndObject();
            json.WriteEndObject();
        }

        static void Number(JsonWriter json, string name, double value)
        {
            json.WritePropertyName(name);
            Finite(json, name, value);
        }

        static void Status(JsonWriter json, DiagnosticsMessage message)
        {
            json.WriteStartObject();
            json.WritePropertyName("level");
            json.WriteValue(message.Level);
            Text(json, "name", message.Name);
            Text(json, "message", message.Message);
            Text(json, "hardware_id", message.HardwareId);
            json.WritePropertyName("values");
            json.WriteStartArray();
            foreach (var pair in message.Values)
            {
                json.WriteStartObject();
                Text(json, "key", pair.Key);
                Text(json, "value", pair.Value);
                json.WriteEndObject();
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        static void Header(JsonWriter json, ControlTime stamp, RosTimeForm form, string frame = "")
        {
            json.WritePropertyName("header");
            json.WriteStartObject();
            if (form == RosTimeForm.Secs)
            {
                // The field seq exists only in ROS 1, and ROS 2 rejects unknown fields.
                json.WritePropertyName("seq");
                json.WriteValue(0);
            }

            json.WritePropertyName("stamp");
            Write(json, stamp.Nanoseconds, form);
            Text(json, "frame_id", frame);
            json.WriteEndObject();
        }

        /// <summary>Returns an upper bound of the length of a string in JSON, in bytes.</summary>
        public static int MaxBytesOf(string text)
        {
            var bytes = 0;
            foreach (var c in text) bytes += c < 0x80 && (char.IsLetterOrDigit(c) || c == '_' || c == '/' || c == '.' || c == '-' || c == ' ') ? 1 : BytesPerCharacter;
            return bytes;
        }

        static void Text(JsonWriter json, string name, string value)
        {
            json.WritePropertyName(name);
            json.WriteValue(value);
        }

        static void Texts(JsonWriter json, string name, string[] values)
        {
            json.WritePropertyName(name);
            json.WriteStartArray();
            foreach (var value in values)
                json.WriteValue(value);
            json.WriteEndArray();
        }

        static void Positions(JsonWriter json, string name, double[] values)
        {
            json.WritePropertyName(name);
            json.WriteStartArray();
            foreach (var value in values) Finite(json, name, value);
            json.WriteEndArray();
        }

        static void Finite(JsonWriter json, string name, double value)
        {
            if (double.IsNaN(value) || double.IsInfinity(value))
                throw new ArgumentException(ProtocolMessages.NotFinite(name, value));
            json.WriteValue(value);
        }

        static void OptionalNumbers(JsonWriter json, string name, double[] values)
        {
            json.WritePropertyName(name);
            json.WriteStartArray();
            foreach (var value in values ?? Array.Empty<double>())
                json.WriteValue(double.IsNaN(value) || double.IsInfinity(value) ? default(double?) : value);
            json.WriteEndArray();
        }
    }
}
