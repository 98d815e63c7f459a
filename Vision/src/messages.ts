/** Reasons why a picture cannot be searched. */
export const pictureMessages = {
  empty: 'the file is empty: copy it again',
  heic: 'it is a HEIC or AVIF picture: set the camera to JPEG, or convert it, for example with ImageMagick: magick IN.heic OUT.jpg',
  otherFormat: 'it is neither a PNG nor a JPEG picture: set the camera to JPEG, or convert it',
  damaged: 'the picture is damaged: copy it again, or take it again',
  damagedOrIncomplete: 'the picture is damaged or incomplete: copy it again, or take it again',
  incomplete: 'the file is incomplete: copy it again',
  tooLarge: (width: number, height: number, maxMegapixels: number) =>
    `${width}x${height} pixels are too many; the maximum is ${maxMegapixels} megapixels: reduce the resolution`,
  noBoxes: 'the first tracked picture has no boxes: send the boxes of both patches with it',
};
