using System;
using System.Collections.Generic;
using Newtonsoft.Json;
using Nowpose.Messages;

namespace Nowpose.Protocol
{
    /// <summary>Writes the fields of messages.</summary>
    static class RosMessageWriter
    {
        // Maximum number of bytes per UTF-16 code unit: a control or rare character is written as \uXXXX; others need at most 3 bytes of UTF-8.
        const int BytesPerCharacter = 6;

        const long NanosecondsPerSecond = 1_000_000_000;

        public static void Header(this JsonWriter json, ControlTime stamp, RosTimeForm form, string frame = "")
        {
            json.StartObject("header");
            if (form == RosTimeForm.Secs)
            {
                // The field seq exists only in ROS 1, and ROS 2 rejects unknown fields.
                json.WritePropertyName("seq");
                json.WriteValue(0);
            }

            json.Time("stamp", stamp.Nanoseconds, form);
            json.Text("frame_id", frame);
            json.WriteEndObject();
        }

        /// <param name="nanoseconds">Time since the epoch, or a length, in ns.</param>
        public static void Time(this JsonWriter json, string name, long nanoseconds, RosTimeForm form)
        {
            // The remainder is never negative: -0.25 s is -1 s and 750 000 000 ns.
            var rest = (nanoseconds % NanosecondsPerSecond + NanosecondsPerSecond) % NanosecondsPerSecond;
            json.StartObject(name);
            json.WritePropertyName(form == RosTimeForm.Secs ? "secs" : "sec");
            json.WriteValue((nanoseconds - rest) / NanosecondsPerSecond);
            json.WritePropertyName(form == RosTimeForm.Secs ? "nsecs" : "nanosec");
            json.WriteValue(rest);
            json.WriteEndObject();
        }

        public static void Text(this JsonWriter json, string name, string value)
        {
            json.WritePropertyName(name);
            json.WriteValue(value);
        }

        public static void Texts(this JsonWriter json, string name, IEnumerable<string> values)
        {
            json.StartArray(name);
            foreach (var value in values) json.WriteValue(value);
            json.WriteEndArray();
        }

        /// <exception cref="ArgumentException">The number is not finite.</exception>
        public static void Number(this JsonWriter json, string name, double value)
        {
            json.WritePropertyName(name);
            json.Finite(name, value);
        }

        /// <exception cref="ArgumentException">A number is not finite.</exception>
        public static void Numbers(this JsonWriter json, string name, double[] values)
        {
            json.StartArray(name);
            foreach (var value in values) json.Finite(name, value);
            json.WriteEndArray();
        }

        /// <summary>Writes numbers that may be unknown: null for each number that is not finite, and an empty array for null.</summary>
        public static void OptionalNumbers(this JsonWriter json, string name, double[] values)
        {
            json.StartArray(name);
            foreach (var value in values ?? Array.Empty<double>())
                json.WriteValue(double.IsNaN(value) || double.IsInfinity(value) ? default(double?) : value);
            json.WriteEndArray();
        }

        /// <summary>Writes a number without a name.</summary>
        /// <param name="name">Name in the exception.</param>
        /// <exception cref="ArgumentException">The number is not finite.</exception>
        public static void Finite(this JsonWriter json, string name, double value)
        {
            if (double.IsNaN(value) || double.IsInfinity(value))
                throw new ArgumentException(ProtocolMessages.NotFinite(name, value));
            json.WriteValue(value);
        }

        public static void StartObject(this JsonWriter json, string name)
        {
            json.WritePropertyName(name);
            json.WriteStartObject();
        }

        public static void StartArray(this JsonWriter json, string name)
        {
            json.WritePropertyName(name);
            json.WriteStartArray();
        }

        /// <summary>Returns an upper bound of the length of a string in JSON, in bytes.</summary>
        public static int MaxBytesOf(string text)
        {
            var bytes = 0;
            foreach (var c in text) bytes += c < 0x80 && (char.IsLetterOrDigit(c) || c == '_' || c == '/' || c == '.' || c == '-' || c == ' ') ? 1 : BytesPerCharacter;
            return bytes;
        }
    }
}
