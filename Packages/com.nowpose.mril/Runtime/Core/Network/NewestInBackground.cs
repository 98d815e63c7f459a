using System;
using System.Threading.Tasks;

namespace Nowpose.Network
{
    /// <summary>
    /// Handles strings on the thread pool, one at a time, because handling a string takes a long time. Keeps only the newest waiting string.
    /// </summary>
    /// <remarks>At any time, at most one string is being handled and one waits.</remarks>
    sealed class NewestInBackground
    {
        readonly Action<string> _handle;
        readonly object _gate = new object();
        string _waiting;
        bool _isRunning;

        /// <param name="handle">Handles one string; must not throw.</param>
        public NewestInBackground(Action<string> handle) => _handle = handle;

        public void Add(string text)
        {
            lock (_gate)
            {
                _waiting = text;
                if (_isRunning) return;
                _isRunning = true;
            }
            Task.Run(HandleAll);
        }

        void HandleAll()
        {
            while (TryTake(out var text)) _handle(text);
        }

        bool TryTake(out string text)
        {
            lock (_gate)
            {
                text = _waiting;
                _waiting = null;
                return _isRunning = text != null;
            }
        }
    }
}
