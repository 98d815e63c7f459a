using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>One renderer of a shown pose, and how it was drawn before.</summary>
    sealed class PosePart
    {
        static readonly int FadeId = Shader.PropertyToID("_Fade");
        static readonly int HatchId = Shader.PropertyToID("_Hatch");

        readonly Renderer _renderer;
        readonly MaterialPropertyBlock _block;
        float _ownFade, _ownHatch;
        bool _isOwnOff, _isTaken;

        /// <param name="block">To work with: shared by all parts.</param>
        public PosePart(Renderer renderer, MaterialPropertyBlock block)
        {
            _renderer = renderer;
            _block = block;
        }

        public bool IsDrawn { get; private set; }

        /// <summary>Null for what nothing ever carried.</summary>
        public PoseCarrier Carrier { get; private set; }

        /// <summary>Looks for what carries it, and remembers how it is drawn unless that is done.</summary>
        public void Take()
        {
            Carrier = PoseCarrier.Of(_renderer.transform, Carrier);
            if (_isTaken) return;
            _isTaken = true;
            _isOwnOff = _renderer.forceRenderingOff;
            _renderer.GetPropertyBlock(_block);
            _ownFade = Own(FadeId);
            _ownHatch = Own(HatchId);
        }

        public void Draw(PoseLook look, float opacity)
        {
            IsDrawn = look.IsDrawn && (Carrier == null || Carrier.IsFollowing);
            Set(look, opacity);
        }

        /// <summary>What was not drawn before the session ended does not come to light by that.</summary>
        public void Abandon(float opacity) => Set(PoseLook.Abandoned, opacity);

        /// <summary>Draws it as before.</summary>
        public void GiveBack()
        {
            if (_isTaken) Set(_isOwnOff, _ownFade, _ownHatch);
            _isTaken = false;
            IsDrawn = true;
        }

        // Of several materials the first: a property block of the user's says it for all of them anyway.
        float Own(int property)
        {
            if (_block.HasFloat(property)) return _block.GetFloat(property);
            var material = _renderer.sharedMaterial;
            return material != null && material.HasProperty(property) ? material.GetFloat(property) : 0;
        }

        void Set(PoseLook look, float opacity) =>
            Set(_isOwnOff || !IsDrawn, Mathf.Max(_ownFade, look.FadeAt(opacity)), look.IsHatched ? 1 : _ownHatch);

        void Set(bool isOff, float fade, float hatch)
        {
            if (_renderer == null) return;
            _renderer.forceRenderingOff = isOff;
            _renderer.GetPropertyBlock(_block);
            _block.SetFloat(FadeId, fade);
            _block.SetFloat(HatchId, hatch);
            _renderer.SetPropertyBlock(_block);
        }
    }
}
