using Nowpose.Kinematics;
using Nowpose.Messages;

namespace Nowpose.Anchoring
{
    /// <summary>A marker that is fixed to the robot's base, with its pose.</summary>
    public sealed class BaseMarker
    {
        /// <summary>Maximum number of characters in a code.</summary>
        const int MaxPayloadLength = 4296;

        const double MaxOffsetMetres = 100;

        /// <summary>
        /// Minimum and maximum length of an edge: smaller codes are not readable from a distance, and larger codes cannot be printed.
        /// </summary>
        const double MinSizeMetres = 0.005, MaxSizeMetres = 5;

        /// <param name="payload">Exact text of the code.</param>
        /// <param name="markerInBase">Marker frame (see <see cref="MarkerSighting"/>) in the robot's base frame.</param>
        /// <param name="sizeMetres">Length of an edge of the printed code; 0 when it is unknown.</param>
        /// <exception cref="InputException">The payload is empty or too long, or the pose, its distance or the size is out of range.</exception>
        public BaseMarker(string payload, in RigidTransform markerInBase, double sizeMetres = 0)
        {
            if (string.IsNullOrEmpty(payload)) throw new InputException(MarkerMessages.PayloadEmpty);
            if (payload.Length > MaxPayloadLength)
                throw new InputException(MarkerMessages.PayloadTooLong(payload.Length, MaxPayloadLength));
            var name = MarkerName.Of(payload);
            SettingRange.Require(markerInBase.X, -MaxOffsetMetres, MaxOffsetMetres, name + ": x of its offset", "m");
            SettingRange.Require(markerInBase.Y, -MaxOffsetMetres, MaxOffsetMetres, name + ": y of its offset", "m");
            SettingRange.Require(markerInBase.Z, -MaxOffsetMetres, MaxOffsetMetres, name + ": z of its offset", "m");
            if (!markerInBase.IsPose()) throw new InputException(MarkerMessages.RotationInvalid(name));
            if (sizeMetres != 0) SettingRange.Require(sizeMetres, MinSizeMetres, MaxSizeMetres, name + ": its size", "m");
            Payload = payload;
            MarkerInBase = markerInBase;
            SizeMetres = sizeMetres;
        }

        public string Payload { get; }
        public RigidTransform MarkerInBase { get; }

        /// <summary>Length of an edge; 0 when it is unknown.</summary>
        public double SizeMetres { get; }

        internal bool IsSameAs(BaseMarker other) => Payload == other.Payload && SizeMetres == other.SizeMetres
            && MarkerInBase.DistanceTo(other.MarkerInBase) < 1e-9 && MarkerInBase.AngleTo(other.MarkerInBase) < 1e-9;
    }

    /// <summary>Formats the name of a marker for messages: shortens long payloads and replaces line breaks.</summary>
    static class MarkerName
    {
        const int Most = 24;

        public static string Of(string payload)
        {
            var start = payload.Length > Most ? payload.Substring(0, Most - 1) + "…" : payload;
            var letters = start.ToCharArray();
            for (var i = 0; i < letters.Length; i++)
                if (char.IsControl(letters[i])) letters[i] = ' ';
            return "marker '" + new string(letters) + "'";
        }
    }
}
