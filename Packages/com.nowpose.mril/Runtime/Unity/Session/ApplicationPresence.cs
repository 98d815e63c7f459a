using UnityEngine;

namespace Nowpose.Unity.Session
{
    /// <summary>Whether the application is in front of its user, by what the engine has told.</summary>
    struct ApplicationPresence
    {
        bool _isPaused, _isUnfocused;

        /// <summary>Paused, or without focus where it does not go on in the background.</summary>
        /// <remarks>In the editor frames go on while the Inspector has the focus instead of the game view.</remarks>
        public bool IsAway => _isPaused || (_isUnfocused && !Application.runInBackground && !Application.isEditor);

        public void Paused(bool isPaused) => _isPaused = isPaused;

        public void Focused(bool hasFocus) => _isUnfocused = !hasFocus;
    }
}
