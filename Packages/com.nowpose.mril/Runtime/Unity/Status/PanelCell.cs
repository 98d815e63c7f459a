using UnityEngine;

namespace Nowpose.Unity.Status
{
    /// <summary>
    /// One text object of a panel. Stores the displayed string, because setting the text of a TextMesh builds a mesh, and reading it allocates a
    /// string.
    /// </summary>
    struct PanelCell
    {
        readonly TextMesh _mesh;
        string _shown;

        public PanelCell(TextMesh mesh)
        {
            _mesh = mesh;
            _shown = null;
        }

        public void Show(string text)
        {
            if (text == _shown || _mesh == null) return;
            _mesh.text = text;
            _shown = text;
        }

        /// <summary>Moves the text object vertically.</summary>
        /// <param name="top">New position of its upper edge, in units of the parent.</param>
        public void MoveTo(float top)
        {
            if (_mesh == null) return;
            var place = _mesh.transform;
            place.localPosition = new Vector3(place.localPosition.x, top, 0);
        }
    }
}
