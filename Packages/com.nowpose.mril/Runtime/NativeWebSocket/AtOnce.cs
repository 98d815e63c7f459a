using System.Threading;

namespace Nowpose.Network
{
    /// <summary>Runs what is posted to it at once, on the thread that posts it.</summary>
    /// <remarks>
    /// NativeWebSocket posts its events to the context it was made under: Unity's waits for the next frame, and without any
    /// they wait until somebody asks for them. Here they come on the thread that has just read them from the socket.
    /// </remarks>
    sealed class AtOnce : SynchronizationContext
    {
        public override void Post(SendOrPostCallback d, object state) => d(state);
        public override void Send(SendOrPostCallback d, object state) => d(state);
        public override SynchronizationContext CreateCopy() => this;
    }
}
