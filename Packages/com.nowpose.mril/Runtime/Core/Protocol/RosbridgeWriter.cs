using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using Newtonsoft.Json;

namespace Nowpose.Protocol
{
    /// <summary>Writes rosbridge v2 messages: valid JSON in every culture, numbers in full precision. Thread-safe.</summary>
    static class RosbridgeWriter
    {
        /// <param name="type">
        /// A type name; it also determines the notation of times (<see cref="RosTopics.TimeFormOf"/>). Null to omit the type.
        /// </param>
        public static string Subscribe(string topic, string type = null) =>
            Write("subscribe", default, topic, json => Optional(json, "type", type));

        public static string Advertise(string topic, string type, RequestId id = default) =>
            Write("advertise", id, topic, json => Optional(json, "type", type));

        /// <exception cref="ArgumentException">A number that must be finite is not.</exception>
        public static string Publish(string topic, IRosMessage message, RosTimeForm form = RosTimeForm.Sec) =>
            Write("publish", default, topic, json =>
            {
                json.WritePropertyName("msg");
                message.Write(json, form);
            });

        public static string CallService(string service, RequestId id = default) => Write("call_service", id, null, json =>
        {
            Optional(json, "service", service);
            json.StartObject("args");
            json.WriteEndObject();
        });

        /// <summary>Writes the response of /rosapi/get_time.</summary>
        public static string TimeResponse(string service, RequestId id, ControlTime time, RosTimeForm form) =>
            Response(service, id, true, json =>
            {
                json.WriteStartObject();
                json.Time("time", time.Nanoseconds, form);
                json.WriteEndObject();
            });

        /// <summary>Writes the response of /rosapi/topics.</summary>
        /// <param name="types">Type of each topic.</param>
        public static string TopicsResponse(string service, RequestId id, IReadOnlyCollection<KeyValuePair<string, string>> types) =>
            Response(service, id, true, json =>
            {
                json.WriteStartObject();
                json.Texts("topics", types.Select(topic => topic.Key));
                json.Texts("types", types.Select(topic => topic.Value));
                json.WriteEndObject();
            });

        /// <summary>Writes a service response whose values are already JSON text.</summary>
        internal static string ServiceResponse(string service, RequestId id, string values) =>
            Response(service, id, true, json => json.WriteRawValue(values));

        /// <summary>Writes the response to a failed call.</summary>
        public static string FailedResponse(string service, RequestId id, string why) =>
            Response(service, id, false, json => json.WriteValue(why));

        /// <param name="level">error, warning, info or none.</param>
        public static string Status(string level, string message, RequestId id = default) => Write("status", id, null, json =>
        {
            Optional(json, "level", level);
            Optional(json, "msg", message);
        });

        static string Response(string service, RequestId id, bool result, Action<JsonWriter> values) =>
            Write("service_response", id, null, json =>
            {
                Optional(json, "service", service);
                json.WritePropertyName("values");
                values(json);
                json.WritePropertyName("result");
                json.WriteValue(result);
            });

        static string Write(string op, RequestId id, string topic, Action<JsonWriter> rest)
        {
            var text = new StringWriter(new StringBuilder(256), CultureInfo.InvariantCulture);
            using (var json = new JsonTextWriter(text))
            {
                json.WriteStartObject();
                Optional(json, "op", op);
                id.Write(json);
                Optional(json, "topic", topic);
                rest(json);
                json.WriteEndObject();
            }

            return text.ToString();
        }

        static void Optional(JsonWriter json, string name, string value)
        {
            if (value != null) json.Text(name, value);
        }
    }
}
