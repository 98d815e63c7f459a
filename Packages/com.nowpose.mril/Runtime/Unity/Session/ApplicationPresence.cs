using UnityEngine;

namespace Nowpose.Unity.Session
{
    /// <summary>Uses Unity's messages to track whether the application is paused or without focus.</summary>
    readonly struct ApplicationPresence
    {
        readonly bool _isPaused, _isUnfocused;

        ApplicationPresence(bool isPaused, bool isUnfocused) => (_isPaused, _isUnfocused) = (isPaused, isUnfocused);

        /// <summary>Whether the application is paused, or has no focus and does not run in the background.</summary>
        /// <remarks>A loss of focus is ignored in the editor, where frames continue while, for example, the Inspector has the focus.</remarks>
        public bool IsAway => _isPaused || (_isUnfocused && !Application.runInBackground && !Application.isEditor);

        public ApplicationPresence Paused(bool isPaused) => new ApplicationPresence(isPaused, _isUnfocused);

        public ApplicationPresence Focused(bool hasFocus) => new ApplicationPresence(_isPaused, !hasFocus);
    }
}
