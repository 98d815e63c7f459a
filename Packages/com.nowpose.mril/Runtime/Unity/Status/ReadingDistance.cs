using UnityEngine;

namespace Nowpose.Unity.Status
{
    /// <summary>
    /// Distance for which the size of a text object is chosen. It is never less than the distance of the viewer. It changes in steps, because letters
    /// whose size changes continuously are illegible.
    /// </summary>
    struct ReadingDistance
    {
        const float MinMetres = 0.3f;
        const float Margin = 1.1f;
        const float MaxRatio = 1.5f;

        /// <summary>Distance in metres; 0 before the first <see cref="Update"/>.</summary>
        public float Metres { get; private set; }

        /// <summary>Adapts the distance to the current distance of the viewer.</summary>
        /// <param name="distance">Distance of the viewer in metres.</param>
        /// <returns>True if <see cref="Metres"/> has changed.</returns>
        public bool Update(float distance)
        {
            distance = Mathf.Max(distance, MinMetres);
            if (distance <= Metres && Metres <= distance * MaxRatio) return false;
            Metres = distance * Margin;
            return true;
        }

        /// <summary>Turns a text object towards the viewer, and scales it so that it is legible from the position of the viewer.</summary>
        public void Face(TextMesh text, Vector3 viewer)
        {
            var place = text.transform;
            place.rotation = Viewer.Facing(place.position, viewer);
            if (Update(Vector3.Distance(place.position, viewer))) Scale(place, LetterSize.At(Metres) / LetterSize.Of(text));
        }

        /// <summary>Sets the world scale of an object, independent of the scale of its parents.</summary>
        public static void Scale(Transform place, float size)
        {
            var above = place.parent != null ? Mathf.Abs(place.parent.lossyScale.x) : 1;
            place.localScale = Vector3.one * (above > 0 ? size / above : size);
        }
    }
}
