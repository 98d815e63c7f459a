namespace Nowpose.Anchoring
{
    /// <summary>Number of ignored sightings for each reason.</summary>
    sealed class SightingFaults
    {
        readonly long[] _counts = new long[(int)SightingFault.TwoPlaces + 1];

        public long this[SightingFault fault] => _counts[(int)fault];

        internal void Add(SightingFault fault) => _counts[(int)fault]++;
    }
}
