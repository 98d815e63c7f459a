using UnityEngine;

namespace Nowpose.Unity.Status
{
    /// <summary>One text of a panel. Written only when it changes, because a new text costs a mesh and reading the text costs a string.</summary>
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

        /// <param name="top">Upper edge, in the parent's units.</param>
        public void MoveTo(float top)
        {
            if (_mesh == null) return;
            var place = _mesh.transform;
            place.localPosition = new Vector3(place.localPosition.x, top, 0);
        }
    }
}
