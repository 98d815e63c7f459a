namespace Nowpose.Anchoring
{
    /// <summary>Markers whose observed relative poses differ from their configured relative poses.</summary>
    public sealed class MarkerConflict
    {
        internal MarkerConflict(BaseMarker marker, BaseMarker other, double metres, double radians) =>
            (Marker, Other, Metres, Radians) = (marker, other, metres, radians);

        /// <summary>Returns whether another conflict is between the same markers, regardless of the deviation.</summary>
        public bool IsOf(MarkerConflict other) => other != null && Marker == other.Marker && Other == other.Other;

        /// <summary>The marker that contradicts the other markers.</summary>
        public BaseMarker Marker { get; }

        /// <summary>Second marker of the conflict if it is unclear which of the two is wrong; otherwise null.</summary>
        public BaseMarker Other { get; }

        /// <summary>Deviation of the marker, or of the two markers from each other, in metres.</summary>
        public double Metres { get; }

        public double Radians { get; }
    }
}
