using Nowpose.Unity.Status;
using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>Label that shows the state of a pose. It turns to face the viewer and keeps a legible size.</summary>
    struct PoseLabel
    {
        ReadingDistance _distance;
        bool _isShown;

        /// <param name="words">Text mesh of the label; null for no label.</param>
        public void Set(TextMesh words, string text)
        {
            _isShown = words != null && text.Length > 0;
            if (words != null) words.text = text;
        }

        /// <summary>Turns the label to the viewer. Call it in each frame.</summary>
        public void Face(TextMesh words)
        {
            if (!_isShown || words == null) return;
            var viewer = Viewer.Head;
            if (viewer != null) _distance.Face(words, viewer.position);
        }
    }
}
