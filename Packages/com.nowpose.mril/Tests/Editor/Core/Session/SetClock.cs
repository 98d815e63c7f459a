namespace Nowpose.Tests.Core.Session
{
    /// <summary>A clock that a test sets.</summary>
    sealed class SetClock : IHeadsetClock
    {
        public HeadsetTime Now { get; set; }
    }
}
