using System.Threading;

namespace Nowpose.Network
{
    /// <summary>Runs posted callbacks immediately, on the posting thread.</summary>
    /// <remarks>
    /// NativeWebSocket posts its events to the context in which it was created. Unity's context waits for the next frame, and without a
    /// context the events wait for a call. With this context they run on the thread that has just read them from the socket.
    /// </remarks>
    sealed class AtOnce : SynchronizationContext
    {
        public override void Post(SendOrPostCallback d, object state) => d(state);
        public override void Send(SendOrPostCallback d, object state) => d(state);
        public override SynchronizationContext CreateCopy() => this;
    }
}
