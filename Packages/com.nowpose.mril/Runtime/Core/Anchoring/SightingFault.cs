namespace Nowpose.Anchoring
{
    /// <summary>Reason why a sighting of a base's marker is ignored.</summary>
    enum SightingFault
    {
        None,

        /// <summary>The source does not track the marker.</summary>
        NotTracked,

        /// <summary>The pose has invalid numbers or an invalid rotation.</summary>
        NoPose,

        /// <summary>The pose is at the application's origin, which devices report for an unknown pose.</summary>
        AtOrigin,

        /// <summary>The sighting is too old, or in the future.</summary>
        Old,

        TooFar,
        TooOblique,

        /// <summary>The marker is behind the viewer's head, out of view of the cameras.</summary>
        Behind,

        /// <summary>The measured edge length differs from the edge length of the base's marker.</summary>
        OtherSize,

        /// <summary>The same code is seen in two places.</summary>
        TwoPlaces,
    }

    /// <summary>Number of ignored sightings for each reason.</summary>
    sealed class SightingFaults
    {
        readonly long[] _counts = new long[(int)SightingFault.TwoPlaces + 1];

        public long this[SightingFault fault] => _counts[(int)fault];

        internal void Add(SightingFault fault) => _counts[(int)fault]++;
    }
}
