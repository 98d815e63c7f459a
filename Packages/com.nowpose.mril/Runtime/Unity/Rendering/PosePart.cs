using System.Collections.Generic;
using Nowpose.Unity.Cell;
using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>One renderer whose look shows the state of a pose. Stores and restores the original look of the renderer.</summary>
    sealed class PosePart
    {
        /// <summary>Minimum fade of a part that cannot show stripes, in states in which other parts are striped.</summary>
        const float MinFadeWithoutStripes = 0.5f;

        /// <summary>Maximum fade of such a part: a tenth of its opacity remains, half of that of a current part at the minimum opacity.</summary>
        const float MaxFadeWithoutStripes = 1.125f;

        readonly Renderer _renderer;
        readonly Transform _root;
        readonly List<CellSignal> _found = new List<CellSignal>();
        readonly List<Material> _drawn = new List<Material>();
        readonly MaterialPropertyBlock _block;
        readonly PoseMaterials _materials;
        PoseMaterial _material;
        Material[] _own, _substitutes;
        MaterialPropertyBlock[] _ownBlocks;
        Color? _ownColour, _leftColour;
        PoseLook _look;
        float _ownFade, _ownHatch, _opacity;
        bool _isOwnOff, _isTaken, _isMarked, _isPoseDrawn, _isHidden, _isSubstituted, _isAlphaSet, _isPatternSet, _hadBlock;

        /// <param name="root">The object of the appearance that draws the part, at or above the renderer.</param>
        /// <param name="block">Property block for temporary use, shared by all parts.</param>
        public PosePart(Renderer renderer, Transform root, MaterialPropertyBlock block, PoseMaterials materials) =>
            (_renderer, _root, _block, _materials) = (renderer, root, block, materials);

        /// <summary>The renderer; equal to null if it was destroyed.</summary>
        public Renderer Renderer => _renderer;

        public bool IsDrawn => _isPoseDrawn && !_isHidden;

        /// <summary>The group of parts to which the part belongs, with the state of their pose.</summary>
        public PartPlace Place { get; set; }

        /// <summary>The rig or gripper that moves the part, or the one that moved it and was destroyed; null if there is none.</summary>
        public PoseCarrier Carrier { get; private set; }

        /// <summary>
        /// The components at or above the renderer that move or change it according to a signal or to joints. Actuated parts and grippers above the
        /// nearest object of the cell do not move the renderer, because this object has its own place; signals above the appearance belong to other parts.
        /// </summary>
        public List<MonoBehaviour> Signals { get; } = new List<MonoBehaviour>();

        /// <summary>Whether one of the part's materials, when it was last drawn, cannot mark a pose as not current.</summary>
        public bool HasUnsuitableMaterial => _material.Means == PoseMeans.None && _renderer != null;

        /// <summary>The first material of a part that cannot mark a pose as not current; null if that material is missing.</summary>
        public Material UnsuitableMaterial
        {
            get
            {
                var own = _isSubstituted ? (IReadOnlyList<Material>)_own : _materials.In(_renderer);
                for (var i = 0; i < own.Count; i++)
                    if (_materials.Of(own[i]).Means == PoseMeans.None) return own[i];
                return own.Count > 0 ? own[0] : null;
            }
        }

        /// <summary>Reads the part's carrier and materials again. The first call also stores whether the renderer was hidden.</summary>
        public void Take()
        {
            Carrier = PoseCarrier.Of(_renderer.transform, Carrier);
            TakeSignals();
            if (!_isSubstituted) _own = null;
            Examine();
            if (_isTaken) return;
            _isTaken = true;
            _isOwnOff = _renderer.forceRenderingOff;
        }

        void TakeSignals()
        {
            Signals.Clear();
            for (var at = _renderer.transform; at != null && !at.TryGetComponent<ICellObject>(out _); at = at.parent)
            {
                if (at.TryGetComponent<ActuatedPart>(out var actuated)) Signals.Add(actuated);
                if (at.TryGetComponent<VirtualGripper>(out var gripper)) Signals.Add(gripper);
            }
            for (var at = _renderer.transform; at != null; at = at == _root ? null : at.parent)
            {
                at.GetComponents(_found);
                Signals.AddRange(_found);
            }
        }

        public void Draw(PoseLook look, float opacity)
        {
            _isPoseDrawn = look.IsDrawn && (Carrier == null || Carrier.IsFollowing);
            Show(look, opacity);
        }

        /// <summary>Gives the part the look of an ended session. A hidden part stays hidden.</summary>
        public void ShowNoSession(float opacity) => Show(PoseLook.NoSession, opacity);

        /// <summary>Draws the part again if it is marked, and its materials have changed since it was drawn. Allocates nothing if they have not.</summary>
        /// <returns>Whether the part was drawn again.</returns>
        public bool FollowMaterials()
        {
            if (!_isMarked || _renderer == null || IsSame(_materials.In(_renderer), _drawn)) return false;
            Show(_look, _opacity);
            return true;
        }

        /// <summary>Restores the original look of the renderer.</summary>
        public void Restore()
        {
            if (_isTaken && _renderer != null)
            {
                RestoreMaterials();
                if (_material.Means == PoseMeans.Alpha) SetAlpha(0);
                else if (_isPatternSet) SetPattern(_ownFade, _ownHatch);
                _renderer.forceRenderingOff = _isOwnOff;
            }
            _isTaken = _isMarked = _isPatternSet = _isHidden = false;
            _isPoseDrawn = true;
        }

        // Returns the user's value of a property: from the renderer's property block, otherwise from its first material.
        float Own(int property)
        {
            if (_block.HasFloat(property)) return _block.GetFloat(property);
            var material = _renderer.sharedMaterial;
            return material != null && material.HasProperty(property) ? material.GetFloat(property) : 0;
        }

        void Show(PoseLook look, float opacity)
        {
            if (_renderer == null) return;
            Examine();
            _isHidden = false;
            (_look, _opacity) = (look, opacity);
            var fade = PoseLook.Combined(look.Fade, 1 - opacity);
            _isMarked = look.IsHatched || fade > 0;
            switch (_material.Means)
            {
                case PoseMeans.Pattern:
                    TakePattern();
                    SetPattern(Mathf.Clamp(fade, _ownFade, 1), look.IsHatched ? 1 : _ownHatch);
                    break;
                case PoseMeans.Alpha:
                    var own = look.IsHatched ? Mathf.Max(look.Fade, MinFadeWithoutStripes) : look.Fade;
                    SetAlpha(Mathf.Min(PoseLook.Combined(own, 1 - opacity), MaxFadeWithoutStripes));
                    break;
                case PoseMeans.None:
                    if (!look.IsHatched) RestoreMaterials();
                    else if (Substitute()) SetSubstitutePattern(fade);
                    else _isHidden = true;
                    break;
            }
            _renderer.forceRenderingOff = _isOwnOff || !IsDrawn;
            _drawn.Clear();
            _drawn.AddRange(_materials.In(_renderer));
        }

        // The user may have assigned other materials since the last frame, even while the part had the substitutes. The part then keeps the
        // user's materials.
        void Examine()
        {
            var materials = _materials.In(_renderer);
            if (_isSubstituted && IsSame(materials, _substitutes)) return;
            if (_isSubstituted) RestoreBlocks(materials.Count);
            _isSubstituted = false;
            var material = _materials.Of(materials);
            if (_isAlphaSet && (material.Means != PoseMeans.Alpha || material.Colour != _material.Colour)) RemoveAlpha();
            _material = material;
            if (_isPatternSet && _material.Means != PoseMeans.Pattern) RemovePattern();
        }

        bool Substitute()
        {
            if (_isSubstituted) return true;
            if (_materials.Substitute == null) return false;
            var materials = _materials.In(_renderer);
            if (_own == null || !IsSame(materials, _own))
            {
                _own = materials.ToArray();
                _substitutes = _materials.SubstitutesFor(_own);
                _ownBlocks = new MaterialPropertyBlock[_own.Length];
                for (var i = 0; i < _own.Length; i++) _ownBlocks[i] = new MaterialPropertyBlock();
            }
            for (var i = 0; i < _own.Length; i++) _renderer.GetPropertyBlock(_ownBlocks[i], i);
            _renderer.sharedMaterials = _substitutes;
            return _isSubstituted = true;
        }

        void RestoreMaterials()
        {
            if (!_isSubstituted) return;
            _isSubstituted = false;
            _renderer.sharedMaterials = _own;
            RestoreBlocks(_own.Length);
        }

        void RestoreBlocks(int materialCount)
        {
            for (var i = 0; i < Mathf.Min(materialCount, _ownBlocks.Length); i++)
                _renderer.SetPropertyBlock(_ownBlocks[i].isEmpty ? null : _ownBlocks[i], i);
        }

        // Uses one block per material. The block of the whole renderer would also affect the user's materials, in which _Fade may have another
        // meaning.
        void SetSubstitutePattern(float fade)
        {
            for (var i = 0; i < _substitutes.Length; i++)
            {
                var drawn = _substitutes[i];
                if (_materials.Of(drawn).Means != PoseMeans.Pattern) continue;
                var own = _ownBlocks[i];
                _renderer.GetPropertyBlock(_block);
                var ownFade = drawn.GetFloat(PoseMaterial.FadeId);
                if (ReferenceEquals(drawn, _own[i]))
                {
                    if (own.HasFloat(PoseMaterial.FadeId)) ownFade = own.GetFloat(PoseMaterial.FadeId);
                    else if (_block.HasFloat(PoseMaterial.FadeId)) ownFade = _block.GetFloat(PoseMaterial.FadeId);
                }
                if (!own.isEmpty) _renderer.GetPropertyBlock(_block, i);
                _block.SetFloat(PoseMaterial.FadeId, Mathf.Clamp(fade, ownFade, 1));
                _block.SetFloat(PoseMaterial.HatchId, 1);
                _renderer.SetPropertyBlock(_block, i);
            }
        }

        // The Font Texture on an inactive object sets the texture of the letters later, when the object is activated.
        bool HasOwnBlock => _renderer.HasPropertyBlock() || _renderer.TryGetComponent<FontTexture>(out _);

        void TakePattern()
        {
            if (_isPatternSet) return;
            _isPatternSet = true;
            _hadBlock = HasOwnBlock;
            _renderer.GetPropertyBlock(_block);
            _ownFade = Own(PoseMaterial.FadeId);
            _ownHatch = Own(PoseMaterial.HatchId);
        }

        void RemovePattern()
        {
            _isPatternSet = false;
            if (_hadBlock) SetPattern(_ownFade, _ownHatch);
            else _renderer.SetPropertyBlock(null);
        }

        void SetPattern(float fade, float hatch)
        {
            _renderer.GetPropertyBlock(_block);
            _block.SetFloat(PoseMaterial.FadeId, fade);
            _block.SetFloat(PoseMaterial.HatchId, hatch);
            _renderer.SetPropertyBlock(_block);
        }

        /// <param name="fade">Fade from 0 (restores the original colour) to <see cref="MaxFadeWithoutStripes"/>.</param>
        void SetAlpha(float fade)
        {
            if (fade <= 0 && !_isAlphaSet) return;
            _renderer.GetPropertyBlock(_block);
            if (!_isAlphaSet)
            {
                _hadBlock = HasOwnBlock;
                _ownColour = _block.HasColor(_material.Colour) ? _block.GetColor(_material.Colour) : (Color?)null;
                // This part has left the material's colour in the user's block.
                if (_ownColour == _leftColour) _ownColour = null;
            }
            _isAlphaSet = fade > 0;
            var colour = _ownColour ?? _renderer.sharedMaterial.GetColor(_material.Colour);
            _leftColour = _hadBlock && !_ownColour.HasValue ? colour : (Color?)null;
            colour.a *= 1 - PoseLook.OpacityLoss * fade;
            _block.SetColor(_material.Colour, colour);
            // Removes the whole block if the part had none: a colour in the block would override later changes of the material's colour.
            _renderer.SetPropertyBlock(_isAlphaSet || _hadBlock ? _block : null);
        }

        // The part has another material. A property block cannot lose a single property, so the colour in a user's block becomes that of the material.
        void RemoveAlpha()
        {
            _isAlphaSet = false;
            _renderer.GetPropertyBlock(_block);
            var material = _renderer.sharedMaterial;
            var colour = _ownColour ?? (material != null && material.HasProperty(_material.Colour) ? material.GetColor(_material.Colour) : (Color?)null);
            if (colour.HasValue) _block.SetColor(_material.Colour, colour.Value);
            _leftColour = _hadBlock && !_ownColour.HasValue ? colour : null;
            _renderer.SetPropertyBlock(_hadBlock ? _block : null);
        }

        static bool IsSame(List<Material> materials, IReadOnlyList<Material> others)
        {
            if (materials.Count != others.Count) return false;
            for (var i = 0; i < others.Count; i++)
                if (!ReferenceEquals(materials[i], others[i])) return false;
            return true;
        }
    }
}
