using UnityEngine;

namespace Nowpose.Unity.Session
{
    /// <summary>Tracks whether the application is in the foreground, from the engine's messages.</summary>
    readonly struct ApplicationPresence
    {
        readonly bool _isPaused, _isUnfocused;

        ApplicationPresence(bool isPaused, bool isUnfocused)
        {
            _isPaused = isPaused;
            _isUnfocused = isUnfocused;
        }

        /// <summary>Whether it is paused, or without focus and not running in the background.</summary>
        /// <remarks>In the editor, frames continue while the Inspector has the focus instead of the game view.</remarks>
        public bool IsAway => _isPaused || (_isUnfocused && !Application.runInBackground && !Application.isEditor);

        public ApplicationPresence Paused(bool isPaused) => new ApplicationPresence(isPaused, _isUnfocused);

        public ApplicationPresence Focused(bool hasFocus) => new ApplicationPresence(_isPaused, !hasFocus);
    }
}
