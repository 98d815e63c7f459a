namespace Nowpose.Tests
{
    /// <summary>A clock that moves when the test says so.</summary>
    sealed class SetClock : IHeadsetClock
    {
        public HeadsetTime Now { get; set; }
    }
}
