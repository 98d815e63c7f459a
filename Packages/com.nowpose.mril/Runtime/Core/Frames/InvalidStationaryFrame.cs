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
    /// <summary>Finds the frame and the field that make a list of stationary frames invalid, and describes them with the value.</summary>
    static class InvalidStationaryFrame
    {
        const int MaxDepth = 64, MaxValueLength = 32;

        static readonly string[] Axes = { "x", "y", "z" }, Components = { "x", "y", "z", "w" };

        static readonly (string Field, JTokenType Type)[] Fields =
        {
            ("header", JTokenType.Object), ("header.stamp", JTokenType.Object), ("header.frame_id", JTokenType.String), ("child_frame_id", JTokenType.String),
            ("transform", JTokenType.Object), ("transform.translation", JTokenType.Object), ("transform.rotation", JTokenType.Object),
        };

        /// <param name="text">Content of the file, which was rejected for <paramref name="fault"/>.</param>
        /// <returns>Null if no frame is found that has this fault.</returns>
        public static string Describe(string text, DropReason fault)
        {
            try
            {
                using var reader = new JsonTextReader(new StringReader(text)) { MaxDepth = MaxDepth, DateParseHandling = DateParseHandling.None };
                return JToken.ReadFrom(reader) is JObject message && message["transforms"] is JArray transforms ? Describe(transforms, fault) : null;
            }
            catch (JsonException)
            {
                return null;
            }
        }

        static string Describe(JArray transforms, DropReason fault)
        {
            var children = new HashSet<string>(StringComparer.Ordinal);
            for (var i = 0; i < transforms.Count; i++)
            {
                if (!(transforms[i] is JObject one)) continue;
                var child = one["child_frame_id"] is { Type: JTokenType.String } name ? (string)name : "";
                var problem = ProblemOf(one, fault, fault == DropReason.DuplicateName && !children.Add(child));
                if (problem != null) return child.Length == 0 ? FrameMessages.OfTransform(i + 1, problem)
                        : FrameMessages.OfFrame(InputException.OneLine(child, MaxValueLength), problem);
            }

            return null;
        }

        static string ProblemOf(JObject one, DropReason fault, bool isTwice)
        {
            switch (fault)
            {
                case DropReason.MissingField: return Missing(one);
                case DropReason.WrongType: return WrongType(one);
                case DropReason.NameTooLong: return LongName(one);
                case DropReason.NotFinite: return Number(one, value => !IsFinite(value) && !IsWrongType(value), FrameMessages.FiniteNumber);
                case DropReason.OutOfRange:
                    var most = TransformsReader.MaxCoordinate;
                    return Number(one, value => IsFinite(value) && Math.Abs((double)value) > most, FrameMessages.Coordinate(most));
                case DropReason.NotUnitQuaternion: return Norm(one);
                case DropReason.OwnParent: return (string)one["child_frame_id"] == (string)one.SelectToken("header.frame_id") ? FrameMessages.IsOwnParent : null;
                case DropReason.DuplicateName: return isTwice ? FrameMessages.OccursTwice : null;
                default: return null;
            }
        }

        static string Missing(JObject one)
        {
            foreach (var (field, _) in Fields)
                if (one.SelectToken(field) == null || field.EndsWith("_id", StringComparison.Ordinal) && one.SelectToken(field).ToString().Length == 0)
                    return FrameMessages.NoField(field);
            foreach (var field in Numbers())
                if (one.SelectToken(field) == null) return FrameMessages.NoField(field);
            return null;
        }

        static string WrongType(JObject one)
        {
            foreach (var (field, type) in Fields)
                if (one.SelectToken(field) is { } value && value.Type != type)
                    return FrameMessages.WrongField(field, Shown(value), type == JTokenType.String ? FrameMessages.Text : FrameMessages.Object);
            return Number(one, IsWrongType, FrameMessages.FiniteNumber);
        }

        static string LongName(JObject one)
        {
            foreach (var (field, type) in Fields)
                if (type == JTokenType.String && one.SelectToken(field) is { Type: JTokenType.String } name && ((string)name).Length > ProtocolLimits.NameLength)
                    return FrameMessages.LongName(field, ((string)name).Length, ProtocolLimits.NameLength);
            return null;
        }

        static string Number(JObject one, Predicate<JToken> isWrong, string allowed)
        {
            foreach (var field in Numbers())
                if (one.SelectToken(field) is { } value && isWrong(value)) return FrameMessages.WrongField(field, Shown(value), allowed);
            return null;
        }

        static string Norm(JObject one)
        {
            var parts = Array.ConvertAll(Components, part => one.SelectToken("transform.rotation." + part) is { } value && IsFinite(value) ? (double)value : 0);
            var norm = Math.Sqrt(parts.Sum(part => part * part));
            return FrameTransform.TryNormalise(ref parts[0], ref parts[1], ref parts[2], ref parts[3]) ? null
                : FrameMessages.Norm(norm, FrameTransform.NormTolerance.ToString(CultureInfo.InvariantCulture));
        }

        static IEnumerable<string> Numbers() =>
            Axes.Select(axis => "transform.translation." + axis).Concat(Components.Select(part => "transform.rotation." + part));

        // Null counts as a number that is not finite, as in the messages of rosbridge.
        static bool IsWrongType(JToken value) => value.Type != JTokenType.Integer && value.Type != JTokenType.Float && value.Type != JTokenType.Null;

        static bool IsFinite(JToken value) =>
            value.Type == JTokenType.Integer || value.Type == JTokenType.Float && !double.IsNaN((double)value) && !double.IsInfinity((double)value);

        static string Shown(JToken value) =>
            InputException.OneLine(value.Type == JTokenType.Float ? value.ToString(Formatting.None).Trim('"') : value.ToString(Formatting.None), MaxValueLength);
    }
}
