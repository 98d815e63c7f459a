using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text;
using Newtonsoft.Json;
using Nowpose.Protocol.Cell;

namespace Nowpose.Protocol
{
    /// <summary>Writes rosbridge v2 messages: valid JSON in every culture, numbers in full precision. Thread-safe.</summary>
    static class RosbridgeWriter
    {
        /// <param name="type">
        /// A type name; it also determines the notation of times (<see cref="RosTopics.TimeFormOf"/>). Null to omit the type.
        /// </param>
        public static string Subscribe(string topic, string type = null) =>
            Write("subscribe", null, topic, json => Optional(json, "type", type));

        public static string Advertise(string topic, string type, string id = null) =>
            Write("advertise", id, topic, json => Optional(json, "type", type));

        /// <exception cref="ArgumentException">A position is not finite.</exception>
        public static string PublishJointState(string topic, JointStateMessage message, RosTimeForm form) =>
            Publish(topic, json => RosMessageWriter.Write(json, message, form));

        /// <exception cref="ArgumentException">A position is not finite.</exception>
        public static string PublishJointTrajectory(string topic, JointTrajectoryMessage message, RosTimeForm form) =>
            Publish(topic, json => RosMessageWriter.Write(json, message, form));

        /// <exception cref="ArgumentException">A number is not finite.</exception>
        public static string PublishTransforms(string topic, TransformsMessage message, RosTimeForm form) =>
            Publish(topic, json => RosMessageWriter.Write(json, message, form));

        /// <exception cref="ArgumentException">A value is not finite.</exception>
        public static string PublishSignals(string topic, SignalsMessage message, RosTimeForm form) =>
            Publish(topic, json => RosMessageWriter.Write(json, message, form));

        /// <summary>Writes a std_msgs/String, for example with the robot description.</summary>
        public static string PublishString(string topic, string data) => Publish(topic, json =>
        {
            json.WriteStartObject();
            Optional(json, "data", data);
            json.WriteEndObject();
        });

        public static string PublishDiagnostics(string topic, DiagnosticsMessage message, RosTimeForm form) =>
            Publish(topic, json => RosMessageWriter.Write(json, message, form));

        public static string CallService(string service, string id = null) => Write("call_service", id, null, json =>
        {
            Optional(json, "service", service);
            json.WritePropertyName("args");
            json.WriteStartObject();
            json.WriteEndObject();
        });

        /// <summary>Writes the response of /rosapi/get_time.</summary>
        public static string TimeResponse(string service, string id, ControlTime time, RosTimeForm form) =>
            Response(service, id, true, json =>
            {
                json.WriteStartObject();
                json.WritePropertyName("time");
                RosMessageWriter.Write(json, time.Nanoseconds, form);
                json.WriteEndObject();
            });

        /// <summary>Writes the response of /rosapi/topics.</summary>
        /// <param name="types">Type of each topic.</param>
        public static string TopicsResponse(string service, string id, IReadOnlyCollection<KeyValuePair<string, string>> types) =>
            Response(service, id, true, json =>
            {
                json.WriteStartObject();
                json.WritePropertyName("topics");
                json.WriteStartArray();
                foreach (var topic in types) json.WriteValue(topic.Key);
                json.WriteEndArray();
                json.WritePropertyName("types");
                json.WriteStartArray();
                foreach (var topic in types) json.WriteValue(topic.Value);
                json.WriteEndArray();
                json.WriteEndObject();
            });

        /// <summary>Writes a service response whose values are already JSON text.</summary>
        internal static string ServiceResponse(string service, string id, string values) =>
            Response(service, id, true, json => json.WriteRawValue(values));

        /// <summary>Writes the response to a failed call.</summary>
        public static string FailedResponse(string service, string id, string why) =>
            Response(service, id, false, json => json.WriteValue(why));

        /// <param name="level">error, warning, info or none.</param>
        public static string Status(string level, string message, string id = null) => Write("status", id, null, json =>
        {
            Optional(json, "level", level);
            Optional(json, "msg", message);
        });

        static string Response(string service, string id, bool result, Action<JsonWriter> values) =>
            Write("service_response", id, null, json =>
            {
                Optional(json, "service", service);
                json.WritePropertyName("values");
                values(json);
                json.WritePropertyName("result");
                json.WriteValue(result);
            });

        static string Publish(string topic, Action<JsonWriter> message) => Write("publish", null, topic, json =>
        {
            json.WritePropertyName("msg");
            message(json);
        });

        static string Write(string op, string id, string topic, Action<JsonWriter> rest)
        {
            var text = new StringWriter(new StringBuilder(256), CultureInfo.InvariantCulture);
            using (var json = new JsonTextWriter(text))
            {
                json.WriteStartObject();
                Optional(json, "op", op);
                Optional(json, "id", id);
                Optional(json, "topic", topic);
                rest(json);
                json.WriteEndObject();
            }

            return text.ToString();
        }

        static void Optional(JsonWriter json, string name, string value)
        {
            if (value == null)
                return;
            json.WritePropertyName(name);
            json.WriteValue(value);
        }
    }
}
