using System.Threading;

namespace Nowpose.Network
{
    /// <summary>Runs posted callbacks immediately, on the posting thread.</summary>
    /// <remarks>
    /// NativeWebSocket posts its events to the synchronization context that was current when its socket was created. Unity's context would run them
    /// in the next frame; without a context they would wait until the application dispatches them. With this context, they run on the thread that
    /// reads from the socket, as soon as a message arrives.
    /// </remarks>
    sealed class ImmediateContext : SynchronizationContext
    {
        public override void Post(SendOrPostCallback d, object state) => d(state);
        public override void Send(SendOrPostCallback d, object state) => d(state);
        public override SynchronizationContext CreateCopy() => this;
    }
}
