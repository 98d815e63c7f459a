using UnityEngine;

namespace Nowpose.Unity.Status
{
    /// <summary>
    /// From how far a text can be read: at least from where the viewer is. It changes in steps, for letters that grow and
    /// shrink all the time cannot be read at all.
    /// </summary>
    struct ReadingDistance
    {
        const float Nearest = 0.3f;
        const float Reserve = 1.1f;
        const float TooFar = 1.5f;

        /// <summary>Metres; 0 before the first <see cref="Update"/>.</summary>
        public float Metres { get; private set; }

        /// <returns>Whether <see cref="Metres"/> has changed.</returns>
        public bool Update(float distance)
        {
            distance = Mathf.Max(distance, Nearest);
            if (distance <= Metres && Metres <= distance * TooFar) return false;
            Metres = distance * Reserve;
            return true;
        }

        /// <summary>Turns a text to the viewer, and scales it.</summary>
        public void Face(TextMesh text, Vector3 viewer)
        {
            var place = text.transform;
            place.rotation = Viewer.Facing(place.position, viewer);
            if (Update(Vector3.Distance(place.position, viewer))) Scale(place, LetterSize.At(Metres) / LetterSize.Of(text));
        }

        /// <summary>Gives an object a size in the world, whatever is above it.</summary>
        public static void Scale(Transform place, float size)
        {
            var above = place.parent != null ? Mathf.Abs(place.parent.lossyScale.x) : 1;
            place.localScale = Vector3.one * (above > 0 ? size / above : size);
        }
    }
}
