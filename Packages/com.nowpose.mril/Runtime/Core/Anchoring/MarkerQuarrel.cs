namespace Nowpose.Anchoring
{
    /// <summary>Markers that are not in relation to each other as they were measured at the base.</summary>
    public sealed class MarkerQuarrel
    {
        internal MarkerQuarrel(BaseMarker marker, BaseMarker other, double metres, double radians)
        {
            Marker = marker;
            Other = other;
            Metres = metres;
            Radians = radians;
        }

        /// <summary>Whether the same markers contradict each other, by whatever.</summary>
        public bool IsOf(MarkerQuarrel other) => other != null && Marker == other.Marker && Other == other.Other;

        /// <summary>The one that the others contradict.</summary>
        public BaseMarker Marker { get; }

        /// <summary>Null where it is clear which one is wrong; else it is one of the two.</summary>
        public BaseMarker Other { get; }

        /// <summary>By how much it is off.</summary>
        public double Metres { get; }

        public double Radians { get; }
    }
}
