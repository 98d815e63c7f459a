using Nowpose.Kinematics;

namespace Nowpose.Anchoring
{
    /// <summary>A marker that is fixed to the robot's base, with its pose.</summary>
    public sealed class BaseMarker
    {
        /// <summary>Maximum number of characters in a code.</summary>
        const int MaxPayloadLength = 4296;

        const double FarthestMetres = 100;

        /// <summary>Minimum and maximum length of an edge: smaller codes are not readable from a distance, larger ones are not prints.</summary>
        const double SmallestMetres = 0.005, LargestMetres = 5;

        /// <param name="payload">Exact text of the code.</param>
        /// <param name="markerInBase">Marker frame (see <see cref="MarkerSighting"/>) in the robot's base frame.</param>
        /// <param name="sizeMetres">Length of an edge of the printed code; 0 when it is unknown.</param>
        /// <exception cref="InputException">The payload is empty or too long, or the pose, its distance or the size is out of range.</exception>
        public BaseMarker(string payload, in RigidTransform markerInBase, double sizeMetres = 0)
        {
            if (string.IsNullOrEmpty(payload)) throw new InputException("marker: its payload is empty; give the text of its code");
            if (payload.Length > MaxPayloadLength)
                throw new InputException("marker: its payload has " + payload.Length + " letters; no code holds more than " + MaxPayloadLength);
            var name = MarkerName.Of(payload);
            SettingRange.Require(markerInBase.X, -FarthestMetres, FarthestMetres, name + ": x of its offset", "m");
            SettingRange.Require(markerInBase.Y, -FarthestMetres, FarthestMetres, name + ": y of its offset", "m");
            SettingRange.Require(markerInBase.Z, -FarthestMetres, FarthestMetres, name + ": z of its offset", "m");
            if (!markerInBase.IsPose()) throw new InputException(name + ": its offset turns nowhere; give three finite angles");
            if (sizeMetres != 0) SettingRange.Require(sizeMetres, SmallestMetres, LargestMetres, name + ": its size", "m");
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
}
