using UnityEngine;

namespace Nowpose.Unity.Status
{
    /// <summary>
    /// Maximum distance at which a text is legible: at least the viewer's distance. It changes in steps, because letters that
    /// change their size continuously are illegible.
    /// </summary>
    struct ReadingDistance
    {
        const float Nearest = 0.3f;
        const float Reserve = 1.1f;
        const float TooFar = 1.5f;

        /// <summary>Distance in metres; 0 before the first <see cref="Update"/>.</summary>
        public float Metres { get; private set; }

        /// <returns>Whether <see cref="Metres"/> has changed.</returns>
        public bool Update(float distance)
        {
            distance = Mathf.Max(distance, Nearest);
            if (distance <= Metres && Metres <= distance * TooFar) return false;
            Metres = distance * Reserve;
            return true;
        }

        /// <summary>Turns a text towards the viewer, and scales it.</summary>
        public void Face(TextMesh text, Vector3 viewer)
        {
            var place = text.transform;
            place.rotation = Viewer.Facing(place.position, viewer);
            if (Update(Vector3.Distance(place.position, viewer))) Scale(place, LetterSize.At(Metres) / LetterSize.Of(text));
        }

        /// <summary>Sets an object's size in the world, independent of its parents' scale.</summary>
        public static void Scale(Transform place, float size)
        {
            var above = place.parent != null ? Mathf.Abs(place.parent.lossyScale.x) : 1;
            place.localScale = Vector3.one * (above > 0 ? size / above : size);
        }
    }
}
