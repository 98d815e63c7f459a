namespace Nowpose.Anchoring
{
    /// <summary>How many sightings did not count, by why.</summary>
    sealed class SightingFaults
    {
        readonly long[] _counts = new long[(int)SightingFault.TwoPlaces + 1];

        public long this[SightingFault fault] => _counts[(int)fault];

        internal void Add(SightingFault fault) => _counts[(int)fault]++;
    }
}
