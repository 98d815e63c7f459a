using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Frames
{
    /// <summary>Finds the transform and the field that make a tf2_msgs/TFMessage invalid, and describes them with the value.</summary>
    static class InvalidTransform
    {
        const int MaxDepth = 64, MaxValueLength = 32;

        static readonly string[] Components = { "x", "y", "z", "w" };

        // Float is any number.
        static readonly (string Name, JTokenType Type)[] Fields =
        {
            ("header", JTokenType.Object), ("header.stamp", JTokenType.Object), ("header.frame_id", JTokenType.String),
            ("child_frame_id", JTokenType.String),
            ("transform", JTokenType.Object), ("transform.translation", JTokenType.Object), ("transform.rotation", JTokenType.Object),
            ("transform.translation.x", JTokenType.Float), ("transform.translation.y", JTokenType.Float),
            ("transform.translation.z", JTokenType.Float), ("transform.rotation.x", JTokenType.Float), ("transform.rotation.y", JTokenType.Float),
            ("transform.rotation.z", JTokenType.Float), ("transform.rotation.w", JTokenType.Float),
        };

        /// <param name="text">The message, which was rejected for <paramref name="fault"/>.</param>
        /// <returns>Null if no transform is found that has this fault.</returns>
        public static string Describe(string text, DropReason fault)
        {
            if (!(Parse(text)?["transforms"] is JArray transforms)) return null;
            var children = new HashSet<string>(StringComparer.Ordinal);
            for (var i = 0; i < transforms.Count; i++)
            {
                if (!(transforms[i] is JObject one)) continue;
                var child = one["child_frame_id"] is { Type: JTokenType.String } name ? (string)name : "";
                var problem = fault == DropReason.DuplicateName && children.Add(child) ? null : ProblemOf(one, fault);
                if (problem != null) return child.Length == 0 ? FrameMessages.OfTransform(i + 1, problem)
                        : FrameMessages.OfFrame(InputException.OneLine(child, MaxValueLength), problem);
            }

            return null;
        }

        /// <returns>Predicate of a sentence whose subject is the transform; null if it does not have this fault.</returns>
        public static string ProblemOf(JObject transform, DropReason fault)
        {
            switch (fault)
            {
                case DropReason.NotUnitQuaternion: return Norm(transform);
                case DropReason.DuplicateName: return FrameMessages.OccursTwice;
                case DropReason.OwnParent:
                    return (string)transform["child_frame_id"] == (string)transform.SelectToken("header.frame_id") ? FrameMessages.IsOwnParent : null;
                default:
                    return Fields.Select(field => ProblemOf(field.Name, field.Type, transform.SelectToken(field.Name), fault))
                        .FirstOrDefault(problem => problem != null);
            }
        }

        /// <summary>Parses a JSON object. Strings that resemble a date remain strings.</summary>
        /// <returns>Null if the text is not a JSON object.</returns>
        public static JObject Parse(string text)
        {
            try
            {
                using var reader = new JsonTextReader(new StringReader(text)) { MaxDepth = MaxDepth, DateParseHandling = DateParseHandling.None };
                return JToken.ReadFrom(reader) as JObject;
            }
            catch (JsonException)
            {
                return null;
            }
        }

        static string ProblemOf(string field, JTokenType type, JToken value, DropReason fault)
        {
            var (isText, isNumber) = (type == JTokenType.String, type == JTokenType.Float);
            var isOfType = isNumber ? IsNumber(value) : value?.Type == type;
            switch (fault)
            {
                case DropReason.MissingField when value == null || isText && value.ToString().Length == 0:
                    return FrameMessages.NoField(field);
                case DropReason.WrongType when value != null && !isOfType:
                    return FrameMessages.WrongField(
                        field, Shown(value), isText ? FrameMessages.Text : isNumber ? FrameMessages.FiniteNumber : FrameMessages.Object);
                case DropReason.NameTooLong when isText && isOfType && ((string)value).Length > ProtocolLimits.NameLength:
                    return FrameMessages.LongName(field, ((string)value).Length, ProtocolLimits.NameLength);
                case DropReason.NotFinite when isNumber && isOfType && !IsFinite(value):
                    return FrameMessages.WrongField(field, Shown(value), FrameMessages.FiniteNumber);
                case DropReason.OutOfRange when isNumber && IsFinite(value) && Math.Abs((double)value) > TransformsReader.MaxCoordinate:
                    return FrameMessages.WrongField(field, Shown(value), FrameMessages.Coordinate(TransformsReader.MaxCoordinate));
                default: return null;
            }
        }

        static string Norm(JObject transform)
        {
            var parts = Components.Select(part => transform.SelectToken("transform.rotation." + part))
                .Select(part => IsFinite(part) ? (double)part : 0).ToArray();
            var norm = Math.Sqrt(parts.Sum(part => part * part));
            return FrameTransform.TryNormalise(ref parts[0], ref parts[1], ref parts[2], ref parts[3]) ? null
                : FrameMessages.Norm(norm, FrameTransform.NormTolerance.ToString(CultureInfo.InvariantCulture));
        }

        // Null counts as a number that is not finite, as in the messages of rosbridge.
        static bool IsNumber(JToken value) =>
            value?.Type == JTokenType.Integer || value?.Type == JTokenType.Float || value?.Type == JTokenType.Null;

        /// <summary>Whether a value is a finite number.</summary>
        /// <param name="value">The value; null if it is missing.</param>
        public static bool IsFinite(JToken value) =>
            value?.Type == JTokenType.Integer || value?.Type == JTokenType.Float && !double.IsNaN((double)value) && !double.IsInfinity((double)value);

        /// <summary>Formats a value from an invalid message on one line, shortened.</summary>
        public static string Shown(JToken value)
        {
            // Newtonsoft.Json adds quotation marks to NaN, and a decimal point to a whole number such as 2e6.
            var text = value.Type == JTokenType.Float ? ((double)value).ToString("R", CultureInfo.InvariantCulture) : value.ToString(Formatting.None);
            return InputException.OneLine(text, MaxValueLength);
        }
    }
}
