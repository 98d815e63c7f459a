namespace Nowpose.Tests.Core.Session
{
    /// <summary>A clock that moves when the test says so.</summary>
    sealed class SetClock : IHeadsetClock
    {
        public HeadsetTime Now { get; set; }
    }
}
