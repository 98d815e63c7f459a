using UnityEngine;

namespace Nowpose.Unity.Session
{
    /// <summary>Tracks whether the application is in the foreground, from the engine's messages.</summary>
    struct ApplicationPresence
    {
        bool _isPaused, _isUnfocused;

        /// <summary>Whether it is paused, or without focus and not running in the background.</summary>
        /// <remarks>In the editor, frames continue while the Inspector has the focus instead of the game view.</remarks>
        public bool IsAway => _isPaused || (_isUnfocused && !Application.runInBackground && !Application.isEditor);

        public void Paused(bool isPaused) => _isPaused = isPaused;

        public void Focused(bool hasFocus) => _isUnfocused = !hasFocus;
    }
}
